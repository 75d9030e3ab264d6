// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The filter "Remeshing: Retriangulate from Samples", called as by MeshLab.

#include "host.h"

#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <tuple>

namespace {

using namespace plugin_test;

constexpr gpr_filter::Filter filter = gpr_filter::RetriangulateFilter;

/// Every twentieth vertex of a layer.
std::vector<gpr::Vec3d> someVertices(const MeshModel& layer)
{
	std::vector<gpr::Vec3d> points;
	for (std::size_t v = 0; v < layer.cm.vert.size(); v += 20) {
		const Point3m& p = layer.cm.vert[v].cP();
		points.push_back({p[0], p[1], p[2]});
	}
	return points;
}

void makeCurrent(Document& document, const MeshModel& layer)
{
	document->setCurrentMesh(layer.id());
}

RichParameterList withSamples(Document& document, int layerNumber)
{
	RichParameterList list = defaults(document, filter);
	list.setValue("SampleLayer", IntValue(layerNumber));
	return list;
}

std::set<std::tuple<float, float, float>> places(const CMeshO& mesh)
{
	std::set<std::tuple<float, float, float>> found;
	for (const CVertexO& v : mesh.vert) {
		found.insert({v.cP()[0], v.cP()[1], v.cP()[2]});
	}
	return found;
}

void expectSameMesh(const gpr_filter::LayerCopy& got, const gpr::TriangleMesh& wanted)
{
	EXPECT_EQ(got.triangles, wanted.triangles);
	ASSERT_EQ(got.positions.size(), wanted.positions.size());
	for (std::size_t v = 0; v < got.positions.size(); ++v) {
		ASSERT_TRUE(got.positions[v] == gpr::Vec3<Scalarm>(wanted.positions[v])) << v;
	}
}

TEST(RetriangulationFilter, VerticesAreTheSamples)
{
	Document                      document;
	MeshModel&                    ball    = addBall(document);
	const std::vector<gpr::Vec3d> samples = someVertices(ball);
	const gpr_filter::LayerCopy   before  = gpr_filter::copyLayer(ball.cm, {});
	const MeshModel&              points  = addPoints(document, samples);
	makeCurrent(document, ball);
	ASSERT_TRUE(apply(document, filter, withSamples(document, points.id())))
		<< document.logText().toStdString();
	EXPECT_EQ(document.layerNum(), 2);
	EXPECT_EQ(std::size_t(ball.cm.vn), samples.size());
	EXPECT_EQ(ball.cm.fn, 2 * ball.cm.vn - 4);
	EXPECT_EQ(places(ball.cm), places(points.cm));
	expectSoundMesh(ball.cm);
	const gpr::RemeshResult wanted =
		gpr::retriangulate(before.view(), samples, gpr::RemeshOptions());
	expectSameMesh(gpr_filter::copyLayer(ball.cm, {}), wanted.mesh);
	EXPECT_TRUE(document.logText().contains("0 were off the surface"));
}

TEST(RetriangulationFilter, SamplesOffTheSurfaceArePutOnIt)
{
	Document                document;
	MeshModel&              sheet  = addSheet(document);
	std::vector<gpr::Vec3d> points = someVertices(sheet);
	points[3].z += 0.25;
	points[5].z -= 0.125;
	const MeshModel& layer = addPoints(document, points);
	makeCurrent(document, sheet);
	ASSERT_TRUE(apply(document, filter, withSamples(document, layer.id())))
		<< document.logText().toStdString();
	for (const CVertexO& v : sheet.cm.vert) {
		ASSERT_NEAR(v.cP()[2], 0, 1e-6);
	}
	EXPECT_TRUE(document.logText().contains("2 were off the surface"));
	EXPECT_TRUE(document.logText().contains("farthest by 0.25 "));
}

TEST(RetriangulationFilter, TransformsAreHonoured)
{
	Document   document;
	MeshModel& ball = addBall(document);
	Matrix44m  turn, shift;
	turn.SetRotateDeg(40, Point3m(1, 2, 3));
	shift.SetTranslate(10, 20, 30);
	ball.cm.Tr                            = shift * turn;
	const std::vector<gpr::Vec3d> samples = someVertices(ball);
	MeshModel&                    points  = addPoints(document, samples);
	// The same places in the world, from another frame.
	points.cm.Tr.SetScale(2, 2, 2);
	for (CVertexO& v : points.cm.vert) {
		v.P() = (ball.cm.Tr * v.P()) / 2;
	}
	makeCurrent(document, ball);
	RichParameterList list = withSamples(document, points.id());
	list.setValue("NewLayer", BoolValue(true));
	ASSERT_TRUE(apply(document, filter, list)) << document.logText().toStdString();
	MeshModel& added = document.layer(2);
	EXPECT_EQ(document->mm(), &added);
	EXPECT_EQ(added.label().toStdString(), "ball_retriangulated");
	EXPECT_TRUE(added.cm.Tr == ball.cm.Tr);
	EXPECT_EQ(std::size_t(added.cm.vn), samples.size());
	expectSoundMesh(added.cm);
	for (const CVertexO& v : added.cm.vert) {
		ASSERT_NEAR(v.cP().Norm(), 1, 1e-3);
	}
}

TEST(RetriangulationFilter, DeletedSamplesDoNotCount)
{
	Document   document;
	MeshModel& ball   = addBall(document);
	MeshModel& points = addPoints(document, someVertices(ball));
	for (std::size_t v = 0; v < points.cm.vert.size(); v += 2) {
		vcg::tri::Allocator<CMeshO>::DeleteVertex(points.cm, points.cm.vert[v]);
	}
	const int left = points.cm.vn;
	makeCurrent(document, ball);
	ASSERT_TRUE(apply(document, filter, withSamples(document, points.id())));
	EXPECT_EQ(ball.cm.vn, left);
}

TEST(RetriangulationFilter, ColourAndQualityAreTheSurfaces)
{
	Document         document;
	MeshModel&       ball   = addBall(document);
	const MeshModel& points = addPoints(document, someVertices(ball));
	makeCurrent(document, ball);
	ASSERT_TRUE(apply(document, filter, withSamples(document, points.id())));
	for (const CVertexO& v : ball.cm.vert) {
		ASSERT_NEAR(v.cC()[0], 128 + 100 * v.cP()[0], 2);
		ASSERT_NEAR(v.cQ(), v.cP()[2], 0.01);
	}
}

void expectRefused(Document& document, const RichParameterList& list, const char* words)
{
	const Snapshot before(document);
	EXPECT_FALSE(apply(document, filter, list));
	EXPECT_TRUE(errorText().contains(words)) << errorText().toStdString();
	EXPECT_TRUE(document.logText().contains(words));
	EXPECT_TRUE(before == Snapshot(document));
}

TEST(RetriangulationFilter, WrongLayersAreNamed)
{
	Document         document;
	const MeshModel& empty = addPoints(document, {});
	const MeshModel& ball  = addBall(document);
	expectRefused(document, withSamples(document, 7), "no layer number 7");
	expectRefused(document, withSamples(document, 7), "0 (points), 1 (ball)");
	expectRefused(document, withSamples(document, empty.id()), "has no vertices");
	expectRefused(document, withSamples(document, ball.id()), "is the surface itself");
}

TEST(RetriangulationFilter, UnusableSamplesAreRefused)
{
	Document   document;
	MeshModel& points = addPoints(document, {{0, 0, NAN}});
	MeshModel& ball   = addBall(document);
	expectRefused(document, withSamples(document, points.id()), "not finite");
	ball.cm.Tr.SetZero();
	expectRefused(document, withSamples(document, points.id()), "no inverse");
}

// From points to mesh, as a user goes.
TEST(RetriangulationFilter, TakesTheSamplingsPoints)
{
	Document   document;
	MeshModel& ball = addBall(document);
	ASSERT_TRUE(apply(document, gpr_filter::SamplingFilter,
					  defaults(document, gpr_filter::SamplingFilter)));
	const int sampleNum = document->mm()->cm.vn;
	makeCurrent(document, ball);
	ASSERT_TRUE(apply(document, filter, defaults(document, filter)));
	EXPECT_EQ(ball.cm.vn, sampleNum);
	expectSoundMesh(ball.cm);
}

} // namespace
