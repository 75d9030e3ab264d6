// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The filter "Compare: Geodesic Poisson Disk vs Quadric Edge Collapse", called as by MeshLab.

#include "host.h"
#include "mesh_bridge.h"

#include <vcg_extras/core/mesh/measure.h>

#include <gtest/gtest.h>

namespace {

using namespace plugin_test;

constexpr gpr_filter::Filter filter = gpr_filter::CompareFilter;

RichParameterList withCount(Document& document, int vertexNum)
{
	RichParameterList list = defaults(document, filter);
	list.setValue("TargetVertexNum", IntValue(vertexNum));
	return list;
}

gpr_filter::LayerCopy copyOf(Document& document, int layer)
{
	return gpr_filter::copyLayer(document.layer(layer).cm, {});
}

/// Expects an untouched ball.
void expectLikeBall(MeshModel& layer)
{
	Document   other;
	MeshModel& ball   = addBall(other);
	const auto wanted = gpr_filter::copyLayer(ball.cm, {});
	const auto got    = gpr_filter::copyLayer(layer.cm, {});
	EXPECT_TRUE(got.sameGeometry(wanted));
	ASSERT_EQ(layer.cm.vert.size(), ball.cm.vert.size());
	for (std::size_t v = 0; v < ball.cm.vert.size(); ++v)
		ASSERT_EQ(layer.cm.vert[v].cQ(), ball.cm.vert[v].cQ());
	EXPECT_EQ(layer.dataMask(), ball.dataMask());
}

TEST(CompareFilter, BothResultsBecomeLayersOfTheSameCount)
{
	Document document;
	addBall(document);
	ASSERT_TRUE(apply(document, filter, withCount(document, 700))) << errorText().toStdString();
	ASSERT_EQ(document.layerNum(), 3);
	expectLikeBall(document.layer(0));
	EXPECT_EQ(document.layer(0).cm.Tr, Matrix44m::Identity());
	EXPECT_EQ(document->mm(), &document.layer(1));
	EXPECT_TRUE(document.layer(1).label().startsWith("ball_geodesic_poisson"));
	EXPECT_TRUE(document.layer(2).label().startsWith("ball_quadric_collapse"));
	EXPECT_EQ(document.layer(1).cm.vn, 700);
	EXPECT_EQ(document.layer(1).cm.fn, 1396);
	EXPECT_EQ(document.layer(2).cm.fn, 1396);
	expectSoundMesh(document.layer(1).cm);
	EXPECT_EQ(std::size_t(document.layer(2).cm.fn), document.layer(2).cm.face.size());
}

TEST(CompareFilter, RemeshedAsTheOtherFilterDoes)
{
	Document compared, remeshed;
	addBall(compared);
	addBall(remeshed);
	ASSERT_TRUE(apply(compared, filter, withCount(compared, 600)));
	RichParameterList list = defaults(remeshed);
	list.setValue("TargetVertexNum", IntValue(600));
	ASSERT_TRUE(apply(remeshed, list));
	EXPECT_TRUE(copyOf(compared, 1).sameGeometry(copyOf(remeshed, 0)));
}

TEST(CompareFilter, LayersLieBesideTheInputOnRequest)
{
	Document   document;
	MeshModel& ball = addBall(document);
	ball.cm.Tr.SetTranslate(5, 6, 7);
	ASSERT_TRUE(apply(document, filter, withCount(document, 300)));
	for (int i = 1; i <= 2; ++i) {
		const Point3m origin = document.layer(i).cm.Tr * Point3m(0, 0, 0);
		EXPECT_NEAR(origin[0], 5 + i * 2.2, 1e-2); // a ball of width 2
		EXPECT_NEAR(origin[1], 6, 1e-6);
		EXPECT_NEAR(origin[2], 7, 1e-6);
	}
	Document          together;
	RichParameterList list = (addBall(together), withCount(together, 300));
	list.setValue("SideBySide", BoolValue(false));
	ASSERT_TRUE(apply(together, filter, list));
	EXPECT_EQ(together.layer(1).cm.Tr, Matrix44m::Identity());
	EXPECT_EQ(together.layer(2).cm.Tr, Matrix44m::Identity());
}

TEST(CompareFilter, ColouredByTheQualityOfTriangles)
{
	Document document;
	addBall(document);
	ASSERT_TRUE(apply(document, filter, withCount(document, 500)));
	gpr::Workers workers(1, nullptr);
	for (int i = 1; i <= 2; ++i) {
		MeshModel& layer = document.layer(i);
		ASSERT_TRUE(layer.hasDataMask(MeshModel::MM_FACEQUALITY | MeshModel::MM_FACECOLOR));
		const gpr_filter::LayerCopy copy   = copyOf(document, i);
		const std::vector<float>    ratios = gpr::radiusRatios(copy.view(), workers);
		for (std::size_t f = 0; f < ratios.size(); ++f) {
			ASSERT_NEAR(layer.cm.face[f].cQ(), ratios[f], 1e-3);
			vcg::Color4b wanted;
			wanted.SetColorRamp(0, 1, float(layer.cm.face[f].cQ()));
			ASSERT_EQ(layer.cm.face[f].cC(), wanted);
		}
	}
}

TEST(CompareFilter, ColouredByDistanceOnOneScale)
{
	Document          document;
	RichParameterList list = (addBall(document), withCount(document, 500));
	list.setValue("ColorBy", EnumValue(1));
	ASSERT_TRUE(apply(document, filter, list));
	Scalarm      largest = 0;
	vcg::Color4b there;
	for (int i = 1; i <= 2; ++i) {
		for (const CFaceO& f : document.layer(i).cm.face) {
			// With 500 vertices, all distances from a ball are lower.
			ASSERT_LT(f.cQ(), 0.05);
			if (f.cQ() > largest) there = f.cC();
			largest = std::max(largest, f.cQ());
		}
	}
	EXPECT_GT(largest, 0);
	EXPECT_EQ(there, vcg::Color4b(vcg::Color4b::Red));
}

TEST(CompareFilter, ColouredByNothingHasNoColour)
{
	Document          document;
	RichParameterList list = (addBall(document), withCount(document, 500));
	list.setValue("ColorBy", EnumValue(2));
	ASSERT_TRUE(apply(document, filter, list));
	for (int i = 1; i <= 2; ++i) {
		EXPECT_FALSE(document.layer(i).hasDataMask(MeshModel::MM_FACEQUALITY));
		EXPECT_FALSE(document.layer(i).hasDataMask(MeshModel::MM_FACECOLOR));
	}
}

TEST(CompareFilter, LogHasTheTable)
{
	Document document;
	addBall(document);
	ASSERT_TRUE(apply(document, filter, withCount(document, 700)));
	const QString log = document.logText().replace(QChar(QChar::Nbsp), ' ').simplified();
	EXPECT_TRUE(log.contains("faces 20480 1396 1396")) << log.toStdString();
	EXPECT_TRUE(log.contains("vertices 10242 700 700"));
	for (const char* row :
		 {"seconds -", "mean 2r/R", "mean aspect ratio", "smallest angle, deg",
		  "largest angle, deg", "6 faces at a vertex, %", "RMS distance -", "p99.9 distance -",
		  "largest distance -", "99.9 % of the points are nearer than p99.9"}) {
		EXPECT_TRUE(log.contains(row)) << row;
	}
	EXPECT_TRUE(log.contains("border loops 0 0 0"));
	EXPECT_TRUE(log.contains("Euler characteristic 2 2 2"));
}

/// Applies the filter; expects a refusal that leaves everything unchanged.
void expectRefusal(Document& document, const RichParameterList& list, const char* words,
				   vcg::CallBackPos* progress = nullptr)
{
	const Snapshot before(document);
	EXPECT_FALSE(apply(document, filter, list, progress));
	EXPECT_TRUE(errorText().contains(words)) << errorText().toStdString();
	EXPECT_TRUE(before == Snapshot(document));
}

TEST(CompareFilter, MoreFacesThanThereAreAreRefusedWithWhatWasReached)
{
	Document document;
	addSheet(document);
	expectRefusal(document, withCount(document, 5000), "ended at 5000 faces");
}

TEST(CompareFilter, TimeLimitIsForAll)
{
	Document          document;
	RichParameterList list = (addBall(document), withCount(document, 500));
	list.setValue("TimeLimit", FloatValue(1e-6f));
	expectRefusal(document, list, "time limit");
}

TEST(CompareFilter, CancelledAtAnyStage)
{
	for (const int share : {10, 40, 75}) {
		Document document;
		addBall(document);
		bool      reached = false;
		DuringRun cancel([&](int percent) {
			reached = reached || percent >= share;
			return percent < share;
		});
		expectRefusal(document, withCount(document, 500), "Cancelled", cancel.callback());
		EXPECT_TRUE(reached);
	}
}

TEST(CompareFilter, DefaultCountsTheWholeLayer)
{
	Document   document;
	MeshModel& ball = addBall(document);
	ball.cm.face[0].SetS();
	ball.cm.sfn = 1;
	EXPECT_EQ(defaults(document, filter).getInt("TargetVertexNum"), 1024);
	EXPECT_EQ(defaults(document, gpr_filter::SamplingFilter).getInt("TargetVertexNum"), 1024);
	EXPECT_EQ(defaults(document, gpr_filter::RemeshFilter).getInt("TargetVertexNum"), 1024);
}

} // namespace
