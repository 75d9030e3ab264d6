// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The search for the count of an error, and the distance it looks at.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/run/error_goal.h>
#include <vcg_extras/core/surface/sampled_distance.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

ErrorGoal goalOf(double largest, std::int64_t start)
{
	ErrorGoal goal;
	goal.largest = largest;
	goal.start   = start;
	goal.most    = 1000000;
	return goal;
}

/// Counts the trials of a search.
struct Search {
	int          trialNum = 0;
	std::int64_t found    = 0;

	template <class ErrorOf>
	Search(const ErrorGoal& goal, const ErrorOf& errorOf)
	{
		found = searchCount(goal, [&](std::int64_t n) {
			++trialNum;
			return ErrorTrial{n, errorOf(n)};
		});
	}
};

} // namespace

TEST(SearchCount, FindsTheCountOfAPowerLaw)
{
	for (double power : {0.4, 0.5, 0.75, 1.0, 1.5}) {
		for (std::int64_t start : {4, 300, 20000, 900000}) {
			const auto   errorOf = [&](std::int64_t n) { return 100 / std::pow(double(n), power); };
			const double wanted  = std::pow(100 / 0.5, 1 / power);
			if (wanted > 900000) continue;
			const Search search(goalOf(0.5, start), errorOf);
			EXPECT_GE(double(search.found), wanted) << power << " from " << start;
			EXPECT_LE(double(search.found), 1.04 * wanted + 1) << power << " from " << start;
			EXPECT_LE(search.trialNum, 12) << power << " from " << start;
		}
	}
}

TEST(SearchCount, EndsNextToAStep)
{
	const Search search(goalOf(1, 100), [](std::int64_t n) { return n < 7777 ? 5.0 : 0.2; });
	EXPECT_GE(search.found, 7777);
	EXPECT_LE(search.found, 8200);
}

TEST(SearchCount, MeetsTheGoalThoughTheErrorIsNoisy)
{
	for (std::uint32_t seed : testSeeds(20)) {
		const auto errorOf = [&](std::int64_t n) {
			Random random(seed * 7919u + std::uint32_t(n));
			return 300 / double(n) * random.between(0.7, 1.3);
		};
		const Search search(goalOf(0.1, 500), errorOf);
		ASSERT_GT(search.found, 0) << "seed " << seed;
		EXPECT_LE(errorOf(search.found), 0.1) << "seed " << seed;
	}
}

TEST(SearchCount, GivesUpAtTheMost)
{
	const Search search(goalOf(0.1, 100), [](std::int64_t) { return 1.0; });
	EXPECT_EQ(search.found, 0);
	EXPECT_LE(search.trialNum, 16);
}

TEST(SearchCount, EndsAtTheLeastCountWhereAllMeetTheGoal)
{
	const Search search(goalOf(0.1, 1000), [](std::int64_t) { return 0.0; });
	EXPECT_EQ(search.found, 4);
	int  trials = 0;
	auto found  = searchCount(goalOf(0.1, 1000), [&](std::int64_t n) {
        ++trials;
        return ErrorTrial{std::max<std::int64_t>(n, 60), 0.01};
    });
	EXPECT_EQ(found, 60);
	EXPECT_LE(trials, 4);
}

TEST(Extent, IsThatOfTheUsableFaces)
{
	TriangleMesh mesh = grid(3, 4, 3, 4);
	mesh.positions.push_back({NAN, 0, 0});
	mesh.positions.push_back({99, 99, 99});
	mesh.triangles.insert(mesh.triangles.end(), {0, 1, 20, 0, 1, 777, 0, -1, 2});
	const MeshExtent extent = extentOf(mesh.view());
	EXPECT_DOUBLE_EQ(extent.area, 12);
	EXPECT_DOUBLE_EQ(extent.diagonal, 5);
	EXPECT_EQ(extentOf(TriangleMesh().view()).diagonal, 0);
}

TEST(SampledDistance, OfTwoSpheresIsThatOfTheirRadii)
{
	Workers            workers(2, nullptr);
	const HalfEdgeMesh a = halfEdgesOf(icosphere(5)), b = halfEdgesOf(icosphere(4, 1.1));
	EXPECT_NEAR(largestSampledDistance(a, b, workers), 0.1, 0.003);
	EXPECT_EQ(largestSampledDistance(a, b, workers), largestSampledDistance(b, a, workers));
	EXPECT_NEAR(largestSampledDistance(a, a, workers), 0, 1e-6);
}

TEST(SampledDistance, IsFoundInsideOfLargeFaces)
{
	Workers workers(2, nullptr);
	// A tent over the middle of two huge triangles, and a hole that only the other way sees.
	TriangleMesh tent = grid(20, 20);
	for (Vec3d& p : tent.positions)
		p.z = std::max(0.0, 0.1 - length(p - Vec3d(0.7, 0.4, 0)));
	const HalfEdgeMesh flat = halfEdgesOf(grid(1, 1));
	EXPECT_NEAR(largestSampledDistance(flat, halfEdgesOf(tent), workers), 0.1, 0.001);
	EXPECT_NEAR(largestSampledDistance(flat, halfEdgesOf(squareFrame(20, 10)), workers), 0.25, 0.1);
}

TEST(SampledDistance, OverARampIsTheIntegral)
{
	for (const int cells : {1, 40}) {
		TriangleMesh tilted = grid(cells, cells);
		for (Vec3d& p : tilted.positions)
			p.z = 0.5 * p.x;
		Workers               workers(2, nullptr);
		const SurfaceDistance d =
			sampledDistance(halfEdgesOf(grid(60, 60)), halfEdgesOf(tilted), workers).mutual.toInput;
		EXPECT_NEAR(d.max, 0.5, 1e-6);
		EXPECT_NEAR(d.rms, 0.5 / std::sqrt(3.0), 1e-4);
		EXPECT_NEAR(d.p999, 0.4995, 3e-4);
	}
}

/// A strip of 20000 faces has less than a thousandth of the area, the rest is 18 faces.
TEST(SampledDistance, ManySmallFacesWeighNoMoreThanTheirArea)
{
	TriangleMesh mesh = grid(100, 100, 1, 0.0005);
	for (Vec3d& p : mesh.positions)
		p.z = 0.2;
	mesh = joined(mesh, shifted(grid(3, 3), {0, 1, 0.1}));
	Workers              workers(2, nullptr);
	const MutualDistance d =
		sampledDistance(halfEdgesOf(grid(1, 1, 9, 9)), halfEdgesOf(mesh), workers).mutual;
	EXPECT_NEAR(d.toInput.p999, 0.1, 1e-3);
	EXPECT_NEAR(d.toInput.max, 0.2, 1e-6);
	EXPECT_EQ(d.larger().max, d.fromInput.max);
}

TEST(SampledDistance, IsTheSameForAnyNumberOfThreads)
{
	const HalfEdgeMesh a = halfEdgesOf(icosphere(5)), b = halfEdgesOf(torus(50, 20));
	Workers            alone(1, nullptr);
	const auto         one = sampledDistance(a, b, alone).mutual;
	for (const int threads : {2, 3}) {
		Workers    workers(threads, nullptr);
		const auto more = sampledDistance(a, b, workers).mutual;
		EXPECT_EQ(one.toInput.rms, more.toInput.rms);
		EXPECT_EQ(one.toInput.p999, more.toInput.p999);
		EXPECT_EQ(one.fromInput.rms, more.fromInput.rms);
		EXPECT_EQ(one.fromInput.p999, more.fromInput.p999);
		EXPECT_EQ(one.larger().max, more.larger().max);
	}
}

TEST(SampledDistance, OfNothingIsNothing)
{
	Workers              workers(1, nullptr);
	const MutualDistance d =
		sampledDistance(HalfEdgeMesh(), halfEdgesOf(grid(2, 2)), workers).mutual;
	EXPECT_EQ(d.larger().max, 0);
	EXPECT_EQ(d.larger().p999, 0);
}

} // namespace gpr::test
