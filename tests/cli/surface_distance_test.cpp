// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Distances between surfaces against closed forms.
#include <vcg_extras/io/mesh/surface_distance.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gpr_test {

using gpr::TriangleMesh;
using gpr::Vec3d;
using gpr::app::DistanceFigures;
using gpr::app::DistanceTarget;

namespace {

/// The unit square in two triangles, moved.
TriangleMesh square(double x, double y, double z)
{
	TriangleMesh mesh;
	mesh.positions = {{x, y, z}, {x + 1, y, z}, {x + 1, y + 1, z}, {x, y + 1, z}};
	mesh.triangles = {0, 1, 2, 0, 2, 3};
	return mesh;
}

/// All of [-1,2]² that is not in the unit square.
TriangleMesh frame()
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0},   {1, 0, 0},  {1, 1, 0}, {0, 1, 0},
					  {-1, -1, 0}, {2, -1, 0}, {2, 2, 0}, {-1, 2, 0}};
	for (int k = 0; k < 4; ++k) {
		const int next = (k + 1) % 4;
		mesh.triangles.insert(mesh.triangles.end(), {k, k + 4, next, next, k + 4, next + 4});
	}
	return mesh;
}

DistanceFigures distance(const TriangleMesh& from, const TriangleMesh& to, std::int64_t samples,
						 int threads = 2)
{
	gpr::Workers workers(threads, nullptr);
	return DistanceTarget(to.view()).from(from.view(), samples, workers);
}

} // namespace

TEST(SurfaceDistance, OfParallelSquaresIsTheirGap)
{
	const DistanceFigures d = distance(square(0, 0, 0.25), square(0, 0, 0), 1000);
	EXPECT_NEAR(d.mean, 0.25, 1e-12);
	EXPECT_NEAR(d.rms, 0.25, 1e-12);
	EXPECT_NEAR(d.p999, 0.25, 1e-12);
	EXPECT_NEAR(d.max, 0.25, 1e-12);
	EXPECT_EQ(d.sampleNum, 1000);
	EXPECT_EQ(d.vertexNum, 4);
}

// From the square to what surrounds it the distance is that to the nearest side: mean 1/6, mean of
// the squares 1/24, largest 1/2 in the middle.
TEST(SurfaceDistance, IsSpreadEvenly)
{
	const DistanceFigures many = distance(square(0, 0, 0), frame(), 200000);
	EXPECT_NEAR(many.mean, 1.0 / 6, 1e-4);
	EXPECT_NEAR(many.rms, std::sqrt(1.0 / 24), 1e-4);
	// Farther than d from all sides is the share (1 - 2 d)² of the square.
	EXPECT_NEAR(many.p999, (1 - std::sqrt(0.001)) / 2, 5e-4);
	EXPECT_LE(many.max, 0.5 + 1e-12);
	EXPECT_GE(many.max, 0.498);
}

TEST(SurfaceDistance, IsOneSided)
{
	const DistanceFigures outwards = distance(frame(), square(0, 0, 0), 1000);
	EXPECT_NEAR(outwards.max, std::sqrt(2.0), 1e-12); // from the frame's outer corners
	EXPECT_LT(distance(square(0, 0, 0), frame(), 1000).max, 0.51);
}

TEST(SurfaceDistance, LosesNoDigitsFarFromTheOrigin)
{
	const DistanceFigures d = distance(square(5e6, 4e5, 100.001), square(5e6, 4e5, 100), 1000);
	EXPECT_NEAR(d.rms, 0.001, 1e-8);
	EXPECT_NEAR(d.max, 0.001, 1e-8);
}

TEST(SurfaceDistance, IsTheSameForAnyNumberOfThreads)
{
	const DistanceFigures one = distance(square(0.3, 0.2, 0.1), frame(), 50000, 1);
	for (const int threads : {2, 3}) {
		const DistanceFigures more = distance(square(0.3, 0.2, 0.1), frame(), 50000, threads);
		EXPECT_EQ(one.rms, more.rms);
		EXPECT_EQ(one.p999, more.p999);
		EXPECT_EQ(one.max, more.max);
	}
}

TEST(SurfaceDistance, PassesOverUnusableFaces)
{
	const double nan   = std::numeric_limits<double>::quiet_NaN();
	TriangleMesh dirty = square(0, 0, 0.25);
	dirty.positions.push_back({nan, 0, 0});
	dirty.positions.push_back({9, 9, 9});
	dirty.triangles.insert(dirty.triangles.end(), {0, 1, 4, 5, 5, 0});
	const DistanceFigures from = distance(dirty, square(0, 0, 0), 1000);
	EXPECT_NEAR(from.max, 0.25, 1e-12);
	EXPECT_NEAR(distance(square(0, 0, 0), dirty, 1000).max, 0.25, 1e-12);
	EXPECT_EQ(from.vertexNum, 4);
	EXPECT_EQ(distance(TriangleMesh(), dirty, 1000).max, 0);
	EXPECT_EQ(distance(dirty, TriangleMesh(), 1000).max, 0);
	EXPECT_EQ(distance(dirty, TriangleMesh(), 1000).p999, 0);
}

// A peak of height h over the middle of the square: its tip is farthest, and of the faces at the
// rim the middle of an edge or of the face.
TEST(SurfaceDistance, FarthestPointsAreThoseOfTheFaces)
{
	TriangleMesh tent = square(0, 0, 0);
	tent.positions.push_back({0.5, 0.5, 0.3});
	tent.triangles            = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
	const TriangleMesh   flat = square(0, 0, 0);
	gpr::Workers         workers(2, nullptr);
	const DistanceTarget target(flat.view());
	const auto           far = target.farthestPoints(tent.view(), {0, 2}, workers);
	ASSERT_EQ(far.size(), 2u);
	for (const gpr::app::FarPoint& p : far) {
		EXPECT_NEAR(p.distance, 0.3, 1e-12);
		EXPECT_EQ(p.position, Vec3d(0.5, 0.5, 0.3));
	}
	// From the tent, the middle of the flat face is not farther than its height allows.
	const auto back = DistanceTarget(tent.view()).farthestPoints(flat.view(), {0, 1}, workers);
	for (const gpr::app::FarPoint& p : back) {
		EXPECT_NEAR(p.distance, 0.3 * 0.5 / std::hypot(0.3, 0.5), 1e-12);
		EXPECT_EQ(p.position, Vec3d(0.5, 0.5, 0)); // the middle of the diagonal
	}
	const TriangleMesh nothing;
	EXPECT_EQ(DistanceTarget(nothing.view()).farthestPoints(flat.view(), {0}, workers)[0].distance,
			  0);
}

} // namespace gpr_test
