// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Even points, and distances measured at even points, against closed forms.
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/surface/surface_distance.h>
#include <vcg_extras/core/surface/triangle_tree.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gpr_test {

using gpr::DistanceFigures;
using gpr::TriangleMesh;
using gpr::Vec3d;

namespace {

/// The unit square in two triangles, moved.
TriangleMesh squareAt(const Vec3d& corner)
{
	TriangleMesh mesh;
	mesh.positions = {corner, corner + Vec3d(1, 0, 0), corner + Vec3d(1, 1, 0),
					  corner + Vec3d(0, 1, 0)};
	mesh.triangles = {0, 1, 2, 0, 2, 3};
	return mesh;
}

/// The unit square with a side on the x axis, tilted: z is 0.75 times y.
TriangleMesh ramp()
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0.8, 0.6}, {0, 0.8, 0.6}};
	mesh.triangles = {0, 1, 2, 0, 2, 3};
	return mesh;
}

/// The square [-1,2]² without the unit square.
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

DistanceFigures distance(const TriangleMesh& from, const TriangleMesh& to,
						 std::int64_t sampleNum = 10000, int threads = 2)
{
	gpr::Workers workers(threads, nullptr);
	return gpr::MeasuredSurface(to.view(), workers).from(from.view(), sampleNum, workers);
}

} // namespace

TEST(MeasuredSurface, ParallelSquaresAreTheirGapApart)
{
	const DistanceFigures d = distance(squareAt({0, 0, 0.25}), squareAt({0, 0, 0}));
	EXPECT_NEAR(d.rms, 0.25, 1e-12);
	EXPECT_NEAR(d.p999, 0.25, 1e-12);
	EXPECT_NEAR(d.max, 0.25, 1e-12);
	EXPECT_NEAR(d.mean, 0.25, 1e-12);
	EXPECT_EQ(d.sampleNum, 10000);
	EXPECT_EQ(d.vertexNum, 4);
}

TEST(MeasuredSurface, OverARampIsTheIntegral)
{
	const DistanceFigures d = distance(ramp(), squareAt({0, 0, 0}));
	EXPECT_NEAR(d.rms, 0.6 / std::sqrt(3.0), 1e-3);
	EXPECT_NEAR(d.p999, 0.999 * 0.6, 0.0005 * 0.6);
	EXPECT_NEAR(d.max, 0.6, 1e-6);
}

TEST(MeasuredSurface, OfFacesIsTheIntegralOverEach)
{
	gpr::Workers             workers(2, nullptr);
	const TriangleMesh       ground = squareAt({0, 0, 0}), tilted = ramp();
	const std::vector<float> d =
		gpr::MeasuredSurface(ground.view(), workers).ofFaces(tilted.view(), workers);
	ASSERT_EQ(d.size(), 2u);
	// Of the square of a linear function with values 0, 0, 0.6 and 0, 0.6, 0.6 at the corners.
	EXPECT_NEAR(d[0], 0.6 / std::sqrt(6.0), 1e-6);
	EXPECT_NEAR(d[1], 0.6 / std::sqrt(2.0), 1e-6);
}

TEST(MeasuredSurface, AnOffsetCostsNoDigits)
{
	const Vec3d far(1e6, -2e6, 3e6);
	EXPECT_NEAR(distance(squareAt(far + Vec3d(0, 0, 1e-3)), squareAt(far)).max, 1e-3, 1e-8);
}

TEST(MeasuredSurface, TakesAnySetOfFaces)
{
	const double nan  = std::numeric_limits<double>::quiet_NaN();
	TriangleMesh wild = squareAt({0, 0, 0});
	wild.positions.push_back({0.5, 0.5, 9});
	wild.positions.push_back({nan, 0, 0});
	// Three faces at an edge, a face with a corner that is not finite, a face with a corner twice.
	wild.triangles.insert(wild.triangles.end(), {0, 2, 4, 0, 1, 5, 1, 1, 2});
	const DistanceFigures there = distance(squareAt({0, 0, 0.25}), wild);
	EXPECT_LE(there.max, 0.25 + 1e-12);
	EXPECT_NEAR(distance(wild, squareAt({0, 0, 0})).max, 9, 1e-12);
	EXPECT_EQ(distance(wild, squareAt({0, 0, 0})).vertexNum, 5);
	EXPECT_EQ(distance(wild, TriangleMesh()).max, 0);
	EXPECT_EQ(distance(wild, TriangleMesh()).p999, 0);
	EXPECT_EQ(distance(TriangleMesh(), wild).max, 0);
}

TEST(MeasuredSurface, SameBitsForAnyNumberOfThreads)
{
	const DistanceFigures one = distance(ramp(), squareAt({0.3, 0, 0}), 50000, 1);
	for (const int threads : {2, 3}) {
		const DistanceFigures more = distance(ramp(), squareAt({0.3, 0, 0}), 50000, threads);
		EXPECT_EQ(one.rms, more.rms);
		EXPECT_EQ(one.p999, more.p999);
		EXPECT_EQ(one.max, more.max);
	}
}

/// The spike has a 4000th of the area. Its tip is the largest distance.
TEST(MeasuredSurface, OneSpikeDoesNotShowInP999)
{
	TriangleMesh spiked = squareAt({0, 0, 0.1});
	spiked.positions.insert(spiked.positions.end(),
							{{0.5, 0.5, 0.1}, {0.5005, 0.5, 0.1}, {0.5, 0.5, 1.1}});
	spiked.triangles.insert(spiked.triangles.end(), {4, 5, 6});
	const DistanceFigures d = distance(spiked, squareAt({0, 0, 0}));
	EXPECT_NEAR(d.p999, 0.1, 1e-4);
	EXPECT_NEAR(d.max, 1.1, 1e-6);
}

// From the square to the frame round the square, the distance is the distance to the nearest side:
// mean 1/6, mean of the squares 1/24, largest 1/2 in the middle.
TEST(MeasuredSurface, IsSpreadEvenly)
{
	const DistanceFigures many = distance(squareAt({0, 0, 0}), frame(), 200000);
	EXPECT_NEAR(many.mean, 1.0 / 6, 1e-4);
	EXPECT_NEAR(many.rms, std::sqrt(1.0 / 24), 1e-4);
	// Farther than d from all sides is the share (1 - 2 d)² of the square.
	EXPECT_NEAR(many.p999, (1 - std::sqrt(0.001)) / 2, 5e-4);
	EXPECT_LE(many.max, 0.5 + 1e-12);
	EXPECT_GE(many.max, 0.498);
}

TEST(MeasuredSurface, IsOneSided)
{
	const DistanceFigures outwards = distance(frame(), squareAt({0, 0, 0}), 1000);
	EXPECT_NEAR(outwards.max, std::sqrt(2.0), 1e-12); // from the frame's outer corners
	EXPECT_LT(distance(squareAt({0, 0, 0}), frame(), 1000).max, 0.51);
}

// A peak of height h over the middle of the square: its tip is the farthest point of each face.
TEST(MeasuredSurface, FarthestPointsAreThoseOfTheFaces)
{
	TriangleMesh tent = squareAt({0, 0, 0});
	tent.positions.push_back({0.5, 0.5, 0.3});
	tent.triangles                  = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
	const TriangleMesh         flat = squareAt({0, 0, 0});
	gpr::Workers               workers(2, nullptr);
	const gpr::MeasuredSurface target(flat.view(), workers);
	const auto                 far = target.farthestPoints(tent.view(), {0, 2}, workers);
	ASSERT_EQ(far.size(), 2u);
	for (const gpr::FarthestPoint& p : far) {
		EXPECT_NEAR(p.distance, 0.3, 1e-12);
		EXPECT_EQ(p.position, Vec3d(0.5, 0.5, 0.3));
	}
	// From the square to the tent, the middle of the square is no farther than the height allows.
	const auto back =
		gpr::MeasuredSurface(tent.view(), workers).farthestPoints(flat.view(), {0, 1}, workers);
	for (const gpr::FarthestPoint& p : back) {
		EXPECT_NEAR(p.distance, 0.3 * 0.5 / std::hypot(0.3, 0.5), 1e-12);
		EXPECT_EQ(p.position, Vec3d(0.5, 0.5, 0)); // the middle of the diagonal
	}
	const TriangleMesh nothing;
	EXPECT_EQ(gpr::MeasuredSurface(nothing.view(), workers)
				  .farthestPoints(flat.view(), {0}, workers)[0]
				  .distance,
			  0);
}

TEST(RadiusRatios, OfEachFace)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {0, 1, 0}, {2, 0, 0}};
	mesh.triangles = {0, 1, 2, 0, 1, 3, 0, 1, 4};
	gpr::Workers             workers(1, nullptr);
	const std::vector<float> ratios = gpr::radiusRatios(mesh.view(), workers);
	EXPECT_NEAR(ratios[0], 1, 1e-6);
	EXPECT_NEAR(ratios[1], 2 * (std::sqrt(2.0) - 1), 1e-6); // of a right triangle with equal legs
	EXPECT_EQ(ratios[2], 0);                                // on a line
}

} // namespace gpr_test
