// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/sampling/fine_spots.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace gpr::test {

TEST(FineSpots, ReachAsFarAsTheySay)
{
	Workers             workers(2, nullptr);
	const Surface       surface = surfaceOf(grid(40, 40, 200, 200), workers);
	const FineSpots     spots   = {{{Vec3d(50, 50, 0), 20, 0.5}, {Vec3d(60, 50, 0), 10, 0.7}},
								   {{Vec3d(50, 60, 0), 15, 0.8}, {Vec3d(150, 150, 0), 1e-3, 0.1}}};
	const Buffer<float> factor  = factorsOf(spots, surface, workers);
	int                 inside  = 0;
	for (int v = 0; v < surface.mesh.vertexNum; ++v) {
		const Vec3d  p = surface.frame.toCaller(surface.mesh.position[std::size_t(v)]);
		const double a = length(p - Vec3d(50, 50, 0)), b = length(p - Vec3d(60, 50, 0));
		const double c = length(p - Vec3d(50, 60, 0));
		if (std::min({std::abs(a - 20), std::abs(b - 10), std::abs(c - 15)}) < 0.01) continue;
		if (length(p - Vec3d(150, 150, 0)) < 0.01) continue;
		const double ofFirst = a < 20 ? 0.5 : b < 10 ? 0.7 : 1;
		EXPECT_NEAR(factor[std::size_t(v)], ofFirst * (c < 15 ? 0.8 : 1), 1e-6);
		inside += factor[std::size_t(v)] < 1;
	}
	EXPECT_GT(inside, 30);
}

TEST(FineSpots, HaveALeastFactorAndMayBeNone)
{
	Workers         workers(1, nullptr);
	const Surface   surface = surfaceOf(grid(3, 3), workers);
	const FineSpots many(5, {{Vec3d(0.5, 0.5, 0), 10, 0.5}});
	for (const float f : factorsOf(many, surface, workers))
		EXPECT_EQ(f, leastFactor);
	for (const float f : factorsOf({{}, {}}, surface, workers))
		EXPECT_EQ(f, 1);
}

/// A bump in a plane: the places are in triangles of the bump, none nearer than the limit.
TEST(PlacesBeyond, AreTheTrianglesThatAreTooFar)
{
	TriangleMesh bump = grid(30, 30);
	for (Vec3d& p : bump.positions)
		p.z = std::max(0.0, 0.1 - length(p - Vec3d(0.7, 0.4, 0)));
	Workers                     workers(2, nullptr);
	const MeasuredSurface       from(bump.view(), workers), to(grid(4, 4).view(), from, workers);
	const std::vector<FarPlace> places = placesBeyond(from, to, 0.05, workers);
	ASSERT_FALSE(places.empty());
	double area = 0;
	for (const FarPlace& p : places) {
		EXPECT_GT(p.distance, 0.05);
		EXPECT_NEAR(p.position.z, p.distance, 1e-9);
		EXPECT_LT(length(p.position - Vec3d(0.7, 0.4, p.position.z)), 0.051);
		area += p.area;
	}
	EXPECT_GT(area, 3.14 * 0.05 * 0.05);
	EXPECT_TRUE(placesBeyond(from, to, 0.11, workers).empty());
}

TEST(PlacesBeyond, AreOnlyThoseInTheRegions)
{
	TriangleMesh bumps = grid(40, 40);
	for (Vec3d& p : bumps.positions) {
		const double near =
			std::min(length(p - Vec3d(0.2, 0.2, 0)), length(p - Vec3d(0.8, 0.7, 0)));
		p.z = 5 + std::max(0.0, 0.1 - near); // the origin of the tree is elsewhere
	}
	Workers               workers(2, nullptr);
	const MeasuredSurface from(bumps.view(), workers);
	const MeasuredSurface to(shifted(grid(4, 4), {0, 0, 5}).view(), from, workers);
	const auto            all = placesBeyond(from, to, 0.05, workers);
	const auto some = placesBeyond(from, to, 0.05, workers, {{{0.1, 0.1, 4}, {0.3, 0.3, 6}}});
	EXPECT_EQ(2 * some.size(), all.size());
	for (const FarPlace& p : some)
		EXPECT_LT(p.position.x, 0.5);
}

/// A large triangle over a thin peak, which lies between the corners and middles of the triangle.
TEST(PlacesBeyond, AreFoundBetweenThePointsThatAreLookedAtFirst)
{
	TriangleMesh peak = grid(60, 60);
	for (Vec3d& p : peak.positions)
		p.z = -std::max(0.0, 0.1 - 2 * length(p - Vec3d(0.55, 0.15, 0)));
	Workers                     workers(2, nullptr);
	const MeasuredSurface       from(grid(3, 3).view(), workers), to(peak.view(), from, workers);
	const std::vector<FarPlace> places = placesBeyond(from, to, 0.03, workers);
	ASSERT_FALSE(places.empty());
	for (const FarPlace& p : places) {
		EXPECT_GT(p.distance, 0.03);
		EXPECT_LT(length(p.position - Vec3d(0.55, 0.15, 0)), 0.05);
	}
	EXPECT_TRUE(placesBeyond(from, to, 0.06, workers).empty());
}

} // namespace gpr::test
