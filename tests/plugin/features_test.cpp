// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The filter "Feature Detection: Second-Order Difference", called as MeshLab calls it.

#include "host.h"

#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <gtest/gtest.h>

namespace {

using namespace plugin_test;

constexpr gpr::Tool tool = gpr::FeatureTool;

/// The sheet folded along x = 0.5 to a roof with a right angle.
MeshModel& addRoof(Document& document)
{
	MeshModel& layer = addSheet(document);
	for (CVertexO& v : layer.cm.vert)
		v.P()[2] = -std::abs(v.P()[0] - 0.5f);
	gpr_filter::updateBoxAndNormals(layer);
	return layer;
}

bool onRidge(const CVertexO& v)
{
	return std::abs(v.cP()[0] - 0.5f) < 1e-6f;
}

bool detect(Document& document)
{
	return apply(document, tool, defaults(document, tool));
}

/// Fails where anything else than the ridge and the faces at it is selected.
void expectRidgeSelected(const CMeshO& mesh)
{
	int vertexNum = 0, faceNum = 0;
	for (const CVertexO& v : mesh.vert) {
		if (v.IsD()) continue;
		ASSERT_EQ(v.IsS(), onRidge(v));
		vertexNum += v.IsS();
	}
	for (const CFaceO& f : mesh.face) {
		if (f.IsD()) continue;
		ASSERT_EQ(f.IsS(), onRidge(*f.cV(0)) || onRidge(*f.cV(1)) || onRidge(*f.cV(2)));
		faceNum += f.IsS();
	}
	EXPECT_EQ(mesh.svn, vertexNum);
	EXPECT_EQ(mesh.sfn, faceNum);
}

TEST(FeatureFilter, RidgeIsSelectedAndItsStrengthIsTheAngle)
{
	Document   document;
	MeshModel& roof   = addRoof(document);
	const auto before = gpr_filter::copyLayer(roof.cm, {});
	ASSERT_TRUE(detect(document)) << document.logText().toStdString();
	EXPECT_EQ(document.layerNum(), 1);
	EXPECT_TRUE(before.sameGeometry(gpr_filter::copyLayer(roof.cm, {})));
	ASSERT_TRUE(roof.hasDataMask(MeshModel::MM_VERTQUALITY));
	expectRidgeSelected(roof.cm);
	EXPECT_EQ(roof.cm.svn, 51);
	for (const CVertexO& v : roof.cm.vert) {
		if (onRidge(v)) {
			ASSERT_NEAR(v.cQ(), 90, 0.5);
		}
		if (std::abs(v.cP()[0] - 0.5f) > 0.1f) {
			ASSERT_LT(v.cQ(), 0.1);
		}
	}
	EXPECT_TRUE(document.logText().contains("50 edges in 1 lines"));
}

TEST(FeatureFilter, IsTheEngines)
{
	Document                    document;
	MeshModel&                  ball = addBall(document);
	const gpr_filter::LayerCopy copy = gpr_filter::copyLayer(ball.cm, {});
	gpr::RemeshOptions          options;
	options.featureThresholds.support = 3;
	const gpr::FeatureResult wanted   = gpr::detectFeatures(copy.view(), options);
	RichParameterList        list     = defaults(document, tool);
	list.setValue("FeatureSupport", FloatValue(3));
	ASSERT_TRUE(apply(document, tool, list));
	for (std::size_t v = 0; v < ball.cm.vert.size(); ++v)
		ASSERT_EQ(ball.cm.vert[v].cQ(), wanted.vertexStrength[v]) << v;
	EXPECT_EQ(ball.cm.svn, 0);
}

TEST(FeatureFilter, OldSelectionGoesAndDeletedElementsAreSkipped)
{
	Document   document;
	MeshModel& roof = addRoof(document);
	for (CFaceO& f : roof.cm.face) {
		f.SetS();
		if (vcg::Barycenter(f)[0] < 0.02) vcg::tri::Allocator<CMeshO>::DeleteFace(roof.cm, f);
	}
	for (CVertexO& v : roof.cm.vert) {
		v.SetS();
		if (v.cP()[0] == 0) vcg::tri::Allocator<CMeshO>::DeleteVertex(roof.cm, v);
	}
	ASSERT_LT(std::size_t(roof.cm.vn), roof.cm.vert.size());
	ASSERT_TRUE(detect(document)) << document.logText().toStdString();
	expectRidgeSelected(roof.cm);
}

TEST(FeatureFilter, SelectionIsARegionForTheRemeshing)
{
	Document   document;
	MeshModel& roof = addRoof(document);
	ASSERT_TRUE(detect(document));
	const auto copy = gpr_filter::copyLayer(roof.cm, {false, true});
	for (std::size_t v = 0; v < roof.cm.vert.size(); ++v)
		ASSERT_EQ(copy.selected[v] != 0, onRidge(roof.cm.vert[v])) << v;
}

TEST(FeatureFilter, CancelledOrRefusedChangesNothing)
{
	Document   document;
	MeshModel& roof = addRoof(document);
	roof.cm.vert[3].SetS();
	const Snapshot before(document);
	DuringRun      cancel([](int) { return false; });
	EXPECT_FALSE(apply(document, tool, defaults(document, tool), cancel.callback()));
	RichParameterList list = defaults(document, tool);
	list.setValue("FeatureWeak", FloatValue(60));
	EXPECT_FALSE(apply(document, tool, list));
	EXPECT_FALSE(errorText().isEmpty());
	EXPECT_TRUE(before == Snapshot(document));
	EXPECT_TRUE(roof.cm.vert[3].IsS());
	EXPECT_FALSE(roof.cm.vert[4].IsS());
}

} // namespace
