// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Crease edges of the input are edges of the result, whole, and no further crease edges appear.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

struct Shape {
	const char*                   name;
	std::function<TriangleMesh()> make;
	double tolerance; ///< of the lines, mesh units; only rounding for straight lines
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

RemeshResult remeshed(const TriangleMesh& mesh, std::int64_t vertexNum,
					  FeatureMode mode = FeatureMode::Auto, int threads = 2)
{
	RemeshOptions options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = vertexNum;
	options.featureMode     = mode;
	options.threads         = threads;
	return remesh(mesh.view(), options);
}

class FeatureLines : public ::testing::TestWithParam<Shape> {};

TEST_P(FeatureLines, AreInTheResultAndNoOthers)
{
	const TriangleMesh mesh = GetParam().make();
	for (int vertexNum : {150, 400, 1000, 3000}) {
		SCOPED_TRACE(vertexNum);
		const RemeshResult r = remeshed(mesh, vertexNum);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(r.mesh.vertexNum(), std::size_t(vertexNum));
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
		EXPECT_EQ(r.report.audit.invertedFaces, 0);
		// With few vertices a note names the number with which the rim of the thin plate would be
		// regular.
		EXPECT_EQ(r.notes.size(), std::size_t(r.report.regularVertexNum > 0 ? 1 : 0));
		const std::vector<Vec3d> lines = sharpSegments(mesh, 40);
		ASSERT_FALSE(lines.empty());
		EXPECT_LE(segmentDistance(lines, sharpSegments(r.mesh, 38)), GetParam().tolerance);
		EXPECT_LE(segmentDistance(sharpSegments(r.mesh, 40), lines), GetParam().tolerance);
	}
}

/// The paper's removal of vertices follows no lines; a note says so if the options ask for lines.
TEST_P(FeatureLines, AreNotFollowedByThePaper)
{
	const TriangleMesh mesh = GetParam().make();
	RemeshOptions      options;
	options.preset       = Preset::Paper;
	options.featureMode  = FeatureMode::Lines;
	const RemeshResult r = remesh(mesh.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.report.featureEdgeNum, 0);
	ASSERT_FALSE(r.notes.empty());
	EXPECT_NE(r.notes.front().find("Feature lines"), std::string::npos);
	EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
}

TEST_P(FeatureLines, AreTheSameWithAnyNumberOfThreads)
{
	const TriangleMesh mesh = GetParam().make();
	const RemeshResult one  = remeshed(mesh, 700, FeatureMode::Auto, 1);
	const RemeshResult four = remeshed(mesh, 700, FeatureMode::Auto, 4);
	ASSERT_EQ(one.status, Status::Ok) << one.message;
	EXPECT_GT(one.report.featureEdgeNum, 0);
	EXPECT_EQ(one.mesh.positions, four.mesh.positions);
	EXPECT_EQ(one.mesh.triangles, four.mesh.triangles);
}

INSTANTIATE_TEST_SUITE_P(
	, FeatureLines,
	::testing::Values(Shape{"cube", [] { return cube(20); }, 1e-5},
					  Shape{"turnedCube",
							[] {
								return rotated(cube(17), {1, 2, 3}, 0.7);
							},
							1e-5},
					  Shape{"lPrism", [] { return lPrism(12); }, 1e-5},
					  Shape{"thinPlate", [] { return thinPlate(40, 0.02); }, 1e-5},
					  Shape{"crossedCreases", [] { return crossedCreases(40, 0.8); }, 1e-5},
					  Shape{"cylinder", [] { return closedCylinder(160, 40, 0.5, 1); }, 0.02}),
	[](const auto& shape) { return std::string(shape.param.name); });

/// Without feature lines the edges of a cube are cut off.
TEST(FeatureLinesOff, AreNotFollowed)
{
	const TriangleMesh mesh = cube(20);
	const RemeshResult r    = remeshed(mesh, 400, FeatureMode::Off);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.report.featureEdgeNum, 0);
	EXPECT_GT(segmentDistance(sharpSegments(mesh, 40), sharpSegments(r.mesh, 20)), 0.01);
}

TEST(FeatureLinesOfNoise, AreNone)
{
	Random             random(7);
	const TriangleMesh mesh  = noisySphere(5, 0.02, random);
	const RemeshResult lines = remeshed(mesh, 1000);
	const RemeshResult off   = remeshed(mesh, 1000, FeatureMode::Off);
	ASSERT_EQ(lines.status, Status::Ok) << lines.message;
	EXPECT_EQ(lines.report.featureEdgeNum, 0);
	EXPECT_EQ(lines.mesh.positions, off.mesh.positions);
	EXPECT_EQ(lines.mesh.triangles, off.mesh.triangles);
}

TEST(FeatureLinesOfNoise, AreThereWhereTheUserWantsThem)
{
	Random             random(7);
	const RemeshResult r = remeshed(noisySphere(4, 0.03, random), 1500, FeatureMode::Lines);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_GT(r.report.featureEdgeNum, 0);
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_EQ(factsOf(r.mesh).euler(), 2);
}

TEST(ConeApex, IsAVertexOfTheResult)
{
	const TriangleMesh mesh = cone(90, 40, 0.5, 0.7);
	for (int vertexNum : {100, 500, 2000}) {
		const RemeshResult r = remeshed(mesh, vertexNum);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(r.report.featureConeApexNum, 1);
		EXPECT_LT(distanceToNearest(r.mesh.positions, {0, 0, 0}), 1e-6) << vertexNum;
		const RemeshResult off = remeshed(mesh, vertexNum, FeatureMode::Off);
		EXPECT_GT(distanceToNearest(off.mesh.positions, {0, 0, 0}), 1e-4) << vertexNum;
	}
}

/// With fewer vertices than the lines need, the lines go, and the count stays.
TEST(FeatureLinesTooMany, AreGivenUp)
{
	for (int vertexNum : {4, 5, 8, 9, 12, 20}) {
		const RemeshResult r = remeshed(lPrism(8), vertexNum);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(r.mesh.vertexNum(), std::size_t(vertexNum));
		EXPECT_TRUE(factsOf(r.mesh).isManifold());
	}
}

/// Eight vertices make a cube of a cube.
TEST(FeatureLinesOfACube, AreAllThereIs)
{
	const RemeshResult r = remeshed(cube(10), 8);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	for (const Vec3d& p : r.mesh.positions) {
		for (double x : {p.x, p.y, p.z})
			EXPECT_LT(std::min(std::abs(x), std::abs(x - 1)), 1e-6);
	}
}

} // namespace

} // namespace gpr::test
