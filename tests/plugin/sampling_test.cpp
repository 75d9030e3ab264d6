// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The filter "Sampling: Geodesic Poisson Disk", called as by MeshLab.

#include "host.h"

#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {

using namespace plugin_test;

constexpr gpr_filter::Filter filter = gpr_filter::SamplingFilter;

/// The engine's samples of a layer.
gpr::SamplingResult engineSamples(const MeshModel& layer, int vertexNum)
{
	gpr::RemeshOptions options;
	options.targetMode               = gpr::TargetMode::VertexNum;
	options.targetVertexNum          = vertexNum;
	const gpr_filter::LayerCopy copy = gpr_filter::copyLayer(layer.cm, {});
	return gpr::samplePoissonDisks(copy.view(), options);
}

bool sample(Document& document, int vertexNum)
{
	RichParameterList list = defaults(document, filter);
	list.setValue("TargetVertexNum", IntValue(vertexNum));
	return apply(document, filter, list);
}

TEST(SamplingFilter, PointsAreTheEngines)
{
	Document                  document;
	MeshModel&                ball   = addBall(document);
	const gpr::SamplingResult wanted = engineSamples(ball, 500);
	ASSERT_TRUE(sample(document, 500)) << document.logText().toStdString();
	ASSERT_EQ(document.layerNum(), 2);
	CMeshO& points = document.layer(1).cm;
	ASSERT_EQ(std::size_t(points.vn), wanted.points.size());
	for (std::size_t i = 0; i < wanted.points.size(); ++i) {
		const Point3m& p = points.vert[i].cP();
		ASSERT_TRUE(gpr::Vec3<Scalarm>(p[0], p[1], p[2]) == gpr::Vec3<Scalarm>(wanted.points[i]))
			<< i;
		ASSERT_EQ(points.vert[i].cQ(), Scalarm(wanted.radii[i]));
	}
}

/// With a varying density, each point has its disk radius as its quality.
TEST(SamplingFilter, QualityIsEachPointsOwnRadius)
{
	Document   document;
	MeshModel& ball = addBall(document); // its quality is z
	for (CVertexO& v : ball.cm.vert)
		if (v.cP()[2] > 0.7) v.SetS();
	RichParameterList list = defaults(document, filter);
	list.setValue("TargetVertexNum", IntValue(500));
	list.setValue("FeatureDiskScale", FloatValue(Scalarm(0.4)));
	ASSERT_TRUE(apply(document, filter, list)) << document.logText().toStdString();
	double atPole = 0, atEquator = HUGE_VAL;
	for (const CVertexO& v : document.layer(1).cm.vert) {
		ASSERT_GT(v.cQ(), 0);
		if (v.cP()[2] > 0.8) atPole = std::max(atPole, double(v.cQ()));
		if (std::abs(v.cP()[2]) < 0.05) atEquator = std::min(atEquator, double(v.cQ()));
	}
	EXPECT_LT(1.6 * atPole, atEquator);
	EXPECT_EQ(ball.cm.vert[0].cQ(), ball.cm.vert[0].cP()[2]);
}

TEST(SamplingFilter, NewLayerOfPoints)
{
	Document   document;
	MeshModel& ball = addBall(document);
	ball.cm.Tr.SetTranslate(1, 2, 3);
	const Snapshot before(document);
	ASSERT_TRUE(sample(document, 500)) << document.logText().toStdString();
	MeshModel& added = document.layer(1);
	EXPECT_EQ(document->mm(), &added);
	EXPECT_EQ(added.label().toStdString(), "ball_samples");
	EXPECT_EQ(added.cm.fn, 0);
	EXPECT_TRUE(added.cm.Tr == ball.cm.Tr);
	EXPECT_TRUE(added.hasDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR));
	EXPECT_NEAR(added.cm.bbox.max[2], 1, 0.1);
	EXPECT_TRUE(document.logText().contains("points"));
	// The ball is unchanged.
	removeLayer(*document, &added);
	document->setCurrentMesh(ball.id());
	EXPECT_TRUE(before == Snapshot(document));
}

TEST(SamplingFilter, NormalAndColourAreTheSurfaces)
{
	Document document;
	addBall(document);
	ASSERT_TRUE(sample(document, 500));
	for (const CVertexO& v : document.layer(1).cm.vert) {
		ASSERT_NEAR(v.cN().Norm(), 1, 1e-5);
		ASSERT_GT(v.cN() * v.cP(), 0.99);
		for (int k = 0; k < 3; ++k) {
			ASSERT_NEAR(v.cC()[k], 128 + 100 * v.cP()[k], 2);
		}
	}
}

TEST(SamplingFilter, NoColourWhereTheMeshHasNone)
{
	Document document;
	addSheet(document);
	ASSERT_TRUE(sample(document, 200));
	EXPECT_FALSE(document.layer(1).hasDataMask(MeshModel::MM_VERTCOLOR));
	EXPECT_TRUE(document.layer(1).hasDataMask(MeshModel::MM_VERTQUALITY));
}

TEST(SamplingFilter, CancelledOrWithoutFacesChangesNothing)
{
	Document document;
	addBall(document);
	const Snapshot          before(document);
	const RichParameterList list = defaults(document, filter);
	DuringRun               cancel([](int) { return false; });
	EXPECT_FALSE(apply(document, filter, list, cancel.callback()));
	EXPECT_TRUE(before == Snapshot(document));
	Document noFaces;
	addPoints(noFaces, {{0, 0, 0}, {1, 0, 0}});
	EXPECT_FALSE(apply(noFaces, filter, list));
	EXPECT_FALSE(errorText().isEmpty());
	EXPECT_EQ(noFaces.layerNum(), 1);
}

TEST(SamplingFilter, FeatureRegionBySelectionWithoutOne)
{
	Document document;
	addBall(document);
	RichParameterList list = defaults(document, filter);
	list.setValue("FeatureRegion", EnumValue(2));
	EXPECT_FALSE(apply(document, filter, list));
	EXPECT_TRUE(errorText().contains("selected"));
}

TEST(LayerCopy, SelectedAreVerticesOrElseCornersOfFaces)
{
	Document   document;
	MeshModel& sheet = addSheet(document);
	sheet.cm.face[100].SetS();
	gpr_filter::CopiedParts parts;
	parts.selection = true;
	for (std::uint8_t mark : gpr_filter::copyLayer(sheet.cm, parts).selected)
		ASSERT_EQ(mark, 0) << "faces do not count unless they are asked for";
	parts.facesCorners               = true;
	const gpr_filter::LayerCopy copy = gpr_filter::copyLayer(sheet.cm, parts);
	std::vector<std::uint8_t>   wanted(sheet.cm.vert.size());
	for (int k = 0; k < 3; ++k) {
		wanted[vcg::tri::Index(sheet.cm, sheet.cm.face[100].cV(k))] = 1;
	}
	EXPECT_EQ(copy.selected, wanted);
	EXPECT_EQ(copy.view().selected, copy.selected.data());
	EXPECT_EQ(gpr_filter::copyLayer(sheet.cm, {}).view().selected, nullptr);
	sheet.cm.vert[7].SetS();
	wanted.assign(sheet.cm.vert.size(), 0);
	wanted[7] = 1;
	EXPECT_EQ(gpr_filter::copyLayer(sheet.cm, parts).selected, wanted);
}

} // namespace
