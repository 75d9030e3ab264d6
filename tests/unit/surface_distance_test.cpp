// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Even points and the distances measured by them, against closed forms.
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/surface/even_points.h>
#include <vcg_extras/core/surface/surface_distance.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gpr_test {

using gpr::SurfaceDistance;
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

/// The unit square with a side on the x axis, tilted so that its height is y times 0.75.
TriangleMesh ramp()
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0.8, 0.6}, {0, 0.8, 0.6}};
	mesh.triangles = {0, 1, 2, 0, 2, 3};
	return mesh;
}

SurfaceDistance distance(const TriangleMesh& from, const TriangleMesh& to, int threads = 2)
{
	gpr::Workers workers(threads, nullptr);
	return gpr::NearSurface(to.view(), workers).from(from.view(), 10000, workers);
}

} // namespace

TEST(NearSurface, ParallelSquaresAreTheirGapApart)
{
	const SurfaceDistance d = distance(squareAt({0, 0, 0.25}), squareAt({0, 0, 0}));
	EXPECT_NEAR(d.rms, 0.25, 1e-6);
	EXPECT_NEAR(d.p999, 0.25, 1e-6);
	EXPECT_NEAR(d.max, 0.25, 1e-6);
}

TEST(NearSurface, OverARampIsTheIntegral)
{
	const SurfaceDistance d = distance(ramp(), squareAt({0, 0, 0}));
	EXPECT_NEAR(d.rms, 0.6 / std::sqrt(3.0), 1e-3);
	EXPECT_NEAR(d.p999, 0.999 * 0.6, 0.0005 * 0.6);
	EXPECT_NEAR(d.max, 0.6, 1e-6);
}

TEST(NearSurface, OfFacesIsTheIntegralOverEach)
{
	gpr::Workers             workers(2, nullptr);
	const TriangleMesh       ground = squareAt({0, 0, 0}), tilted = ramp();
	const std::vector<float> d =
		gpr::NearSurface(ground.view(), workers).ofFaces(tilted.view(), workers);
	ASSERT_EQ(d.size(), 2u);
	// Of the square of a linear function with values 0, 0, 0.6 and 0, 0.6, 0.6 at the corners.
	EXPECT_NEAR(d[0], 0.6 / std::sqrt(6.0), 1e-6);
	EXPECT_NEAR(d[1], 0.6 / std::sqrt(2.0), 1e-6);
}

TEST(NearSurface, AnOffsetCostsNoDigits)
{
	const Vec3d far(1e6, -2e6, 3e6);
	EXPECT_NEAR(distance(squareAt(far + Vec3d(0, 0, 1e-3)), squareAt(far)).max, 1e-3, 1e-8);
}

TEST(NearSurface, TakesAnySetOfFaces)
{
	const double nan  = std::numeric_limits<double>::quiet_NaN();
	TriangleMesh wild = squareAt({0, 0, 0});
	wild.positions.push_back({0.5, 0.5, 9});
	wild.positions.push_back({nan, 0, 0});
	// Three faces at an edge, one with a corner that is not finite, one with a corner twice.
	wild.triangles.insert(wild.triangles.end(), {0, 2, 4, 0, 1, 5, 1, 1, 2});
	const SurfaceDistance there = distance(squareAt({0, 0, 0.25}), wild);
	EXPECT_LE(there.max, 0.25 + 1e-6);
	EXPECT_NEAR(distance(wild, squareAt({0, 0, 0})).max, 9, 1e-5);
	EXPECT_EQ(distance(wild, TriangleMesh()).max, 0);
	EXPECT_EQ(distance(wild, TriangleMesh()).p999, 0);
	EXPECT_EQ(distance(TriangleMesh(), wild).max, 0);
}

TEST(NearSurface, SameBitsForAnyNumberOfThreads)
{
	const SurfaceDistance one = distance(ramp(), squareAt({0.3, 0, 0}), 1);
	for (const int threads : {2, 3}) {
		const SurfaceDistance more = distance(ramp(), squareAt({0.3, 0, 0}), threads);
		EXPECT_EQ(one.rms, more.rms);
		EXPECT_EQ(one.p999, more.p999);
		EXPECT_EQ(one.max, more.max);
	}
}

/// The spike has a 4000th of the area. Its tip is the largest distance.
TEST(NearSurface, OneSpikeDoesNotShowInP999)
{
	TriangleMesh spiked = squareAt({0, 0, 0.1});
	spiked.positions.insert(spiked.positions.end(),
							{{0.5, 0.5, 0.1}, {0.5005, 0.5, 0.1}, {0.5, 0.5, 1.1}});
	spiked.triangles.insert(spiked.triangles.end(), {4, 5, 6});
	const SurfaceDistance d = distance(spiked, squareAt({0, 0, 0}));
	EXPECT_NEAR(d.p999, 0.1, 1e-4);
	EXPECT_NEAR(d.max, 1.1, 1e-6);
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
