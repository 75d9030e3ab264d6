// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The filter "Feature Detection: Second-Order Difference", called as by MeshLab.

#include "host.h"

#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <gtest/gtest.h>

namespace {

using namespace plugin_test;

constexpr gpr_filter::Filter filter = gpr_filter::FeatureFilter;

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

gpr_filter::CopiedParts withSelection()
{
	gpr_filter::CopiedParts parts;
	parts.selection = true;
	return parts;
}

bool detect(Document& document)
{
	return apply(document, filter, defaults(document, filter));
}

/// Expects that exactly the vertices of the ridge are selected.
void expectRidgeSelected(const CMeshO& mesh)
{
	int vertexNum = 0;
	for (const CVertexO& v : mesh.vert) {
		if (v.IsD()) continue;
		ASSERT_EQ(v.IsS(), onRidge(v));
		vertexNum += v.IsS();
	}
	EXPECT_EQ(mesh.svn, vertexNum);
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
	for (const CFaceO& f : roof.cm.face)
		ASSERT_FALSE(f.IsS()) << "selected faces are those to be remeshed alone";
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
	RichParameterList        list     = defaults(document, filter);
	list.setValue("FeatureSupport", FloatValue(3));
	ASSERT_TRUE(apply(document, filter, list));
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
	const auto copy = gpr_filter::copyLayer(roof.cm, withSelection());
	for (std::size_t v = 0; v < roof.cm.vert.size(); ++v)
		ASSERT_EQ(copy.selected[v] != 0, onRidge(roof.cm.vert[v])) << v;
}

/// The mean area of the faces near the plane of the ridge, or far from the plane.
double meanFaceArea(const CMeshO& mesh, bool nearRidge)
{
	double area = 0;
	int    num  = 0;
	for (const CFaceO& f : mesh.face) {
		const bool near = std::abs(vcg::Barycenter(f)[0] - 0.5f) < 0.03;
		const bool far  = std::abs(vcg::Barycenter(f)[0] - 0.5f) > 0.3;
		if (nearRidge ? !near : !far) continue;
		area += vcg::DoubleArea(f) / 2;
		++num;
	}
	return area / num;
}

/// The proposals of the dialogs, one filter after the other.
TEST(FeatureFilter, RemeshingAfterwardsIsDenserAtTheFeatures)
{
	Document   document;
	MeshModel& roof      = addRoof(document);
	const int  vertexNum = roof.cm.vn;
	ASSERT_TRUE(detect(document));
	const RichParameterList proposed = defaults(document, gpr_filter::RemeshFilter);
	EXPECT_EQ(proposed.getFloat("FeatureDiskScale"), Scalarm(0.5));
	EXPECT_FALSE(proposed.getBool("Selected"));
	RichParameterList list = proposed;
	list.setValue("TargetVertexNum", IntValue(vertexNum / 2));
	ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();
	EXPECT_EQ(roof.cm.vn, vertexNum / 2);
	EXPECT_TRUE(document.logText().contains("made of 51 selected vertices"));
	EXPECT_NEAR(roof.cm.bbox.DimX(), 1, 1e-3) << "the whole roof";
	EXPECT_LT(meanFaceArea(roof.cm, true), 0.5 * meanFaceArea(roof.cm, false));
}

/// A disk scale asks for the detected region by itself.
TEST(FeatureFilter, DiskScaleAloneIsTheDetectedRegion)
{
	Document          one, two;
	MeshModel&        alone = addRoof(one);
	MeshModel&        named = addRoof(two);
	RichParameterList list  = defaults(one, gpr_filter::RemeshFilter);
	EXPECT_EQ(list.getFloat("FeatureDiskScale"), Scalarm(0));
	list.setValue("TargetVertexNum", IntValue(700));
	list.setValue("FeatureDiskScale", FloatValue(Scalarm(0.4)));
	ASSERT_TRUE(apply(one, list)) << one.logText().toStdString();
	list.setValue("FeatureRegion", EnumValue(1));
	ASSERT_TRUE(apply(two, list)) << two.logText().toStdString();
	// The plugin tells the newest document.
	EXPECT_EQ(two.logText().count("made of 51 detected vertices"), 2);
	EXPECT_TRUE(
		gpr_filter::copyLayer(alone.cm, {}).sameGeometry(gpr_filter::copyLayer(named.cm, {})));
	EXPECT_LT(meanFaceArea(alone.cm, true), 0.5 * meanFaceArea(alone.cm, false));
}

/// Scripts of older versions name a scale of 0.5 and no region.
TEST(FeatureFilter, ARegionThatIsSwitchedOffStaysOff)
{
	Document   one, two;
	MeshModel& plain = addRoof(one);
	MeshModel& off   = addRoof(two);
	ASSERT_TRUE(apply(one, defaults(one, gpr_filter::RemeshFilter)));
	RichParameterList list = defaults(two, gpr_filter::RemeshFilter);
	list.setValue("FeatureDiskScale", FloatValue(Scalarm(0.5)));
	list.setValue("FeatureRegion", EnumValue(0));
	ASSERT_TRUE(apply(two, list));
	EXPECT_TRUE(
		gpr_filter::copyLayer(plain.cm, {}).sameGeometry(gpr_filter::copyLayer(off.cm, {})));
	EXPECT_TRUE(two.logText().contains("feature disk scale has no effect"));
}

TEST(FeatureFilter, CancelledOrRefusedChangesNothing)
{
	Document   document;
	MeshModel& roof = addRoof(document);
	roof.cm.vert[3].SetS();
	const Snapshot before(document);
	DuringRun      cancel([](int) { return false; });
	EXPECT_FALSE(apply(document, filter, defaults(document, filter), cancel.callback()));
	RichParameterList list = defaults(document, filter);
	list.setValue("FeatureWeak", FloatValue(60));
	EXPECT_FALSE(apply(document, filter, list));
	EXPECT_FALSE(errorText().isEmpty());
	EXPECT_TRUE(before == Snapshot(document));
	EXPECT_TRUE(roof.cm.vert[3].IsS());
	EXPECT_FALSE(roof.cm.vert[4].IsS());
}

} // namespace
