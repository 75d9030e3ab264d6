// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The search for the count of an error, and the measured distance.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/sampling/count_search.h>
#include <vcg_extras/core/sampling/target.h>
#include <vcg_extras/core/surface/surface_distance.h>

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

/// The whole search; trial(n) makes the trial of a count.
template <class Trial>
std::int64_t searchCount(const ErrorGoal& goal, const Trial& trial)
{
	CountSearch search(goal);
	for (std::int64_t next = search.first(); next > 0;)
		next = search.after(next, trial(next));
	return search.found();
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

double largestDistance(const HalfEdgeMesh& a, const HalfEdgeMesh& b, Workers& workers)
{
	return sampledBetween(a, b, workers).mutual.larger().max;
}

} // namespace

/// The share of the surface beyond the goal falls with each finer trial.
TEST(SearchCount, MeetsTheGoalWithinFiveTrials)
{
	for (const double power : {0.75, 1.0}) {
		for (const std::int64_t start : {300, 8000, 20000, 100000}) {
			const auto errorOf = [&](std::int64_t n) {
				return 0.5 * std::pow(20000 / double(n), power);
			};
			std::int64_t trials = 0;
			const auto   trial  = [&](std::int64_t n) {
                ++trials;
                ErrorTrial t{n, errorOf(n)};
                t.share = t.error <= 0.5 ? 0 : std::min(0.5, 0.002 * std::exp(3 * t.error));
                return t;
			};
			const std::int64_t found = searchCount(goalOf(0.5, start), trial);
			EXPECT_LE(trials, 5);
			if (start < 8000) continue; // too far off for five trials
			EXPECT_GE(found, 20000) << power << " from " << start;
			EXPECT_LE(found, 50000) << power << " from " << start;
		}
	}
}

/// Thin walls: until the triangles are as small as the walls are thick, most of the surface misses
/// the goal, and the forecast is far too small.
TEST(SearchCount, RecoversFromAForecastFarTooSmall)
{
	const auto trial = [](std::int64_t n) {
		ErrorTrial t{n, n < 1500 ? 2.0 : 0.4};
		t.share = n < 60 ? 0.97 : n < 700 ? 0.6 : n < 1500 ? 0.2 : 0;
		return t;
	};
	for (const std::int64_t start : {5, 20, 100}) {
		const std::int64_t found = searchCount(goalOf(0.5, start), trial);
		EXPECT_GE(found, 1500) << "from " << start;
		EXPECT_LE(found, 6000) << "from " << start;
	}
}

TEST(SearchCount, RaisesTheCountALittleWhereFewPlacesMissTheGoal)
{
	std::vector<std::int64_t> tried;
	const std::int64_t        found = searchCount(goalOf(1, 1000), [&](std::int64_t n) {
        tried.push_back(n);
        const bool isLast = tried.size() == 3;
        return ErrorTrial{n, isLast ? 0.95 : 1.5, isLast ? 0 : 0.0001};
    });
	ASSERT_GE(tried.size(), 3u);
	EXPECT_EQ(tried[1], 1150);
	EXPECT_EQ(tried[2], 1323);
	EXPECT_EQ(found, 1323);
}

TEST(SearchCount, RaisesTheCountWhereMuchIsBeyond)
{
	std::vector<std::int64_t> tried;
	searchCount(goalOf(1, 1000), [&](std::int64_t n) {
		tried.push_back(n);
		return ErrorTrial{n, n > 3000 ? 0.95 : 3, n > 3000 ? 0 : 0.2};
	});
	ASSERT_GE(tried.size(), 3u);
	EXPECT_EQ(tried[1], 2000) << "the first count is a forecast";
	EXPECT_GT(tried[2], 4000);
}

TEST(SearchCount, EndsWithTheFewestThatMet)
{
	const Search search(goalOf(1, 8000), [](std::int64_t n) { return n < 2000 ? 1.3 : 0.5; });
	EXPECT_GE(search.found, 2000);
	EXPECT_LT(search.found, 4000);
	EXPECT_LE(search.trialNum, 5);
}

/// As on the fandisk: a count misses the goal at few places only.
TEST(SearchCount, ComesNearTheFewestWhereFewPlacesMissTheGoal)
{
	constexpr std::int64_t fewest  = 1700;
	int                    trials  = 0;
	const auto             errorOf = [&](std::int64_t n) {
        ++trials;
        const double error = 0.73 * std::pow(3058 / double(n), 0.64);
        return n < fewest ? ErrorTrial{n, 1.2, 1e-5} : ErrorTrial{n, std::min(error, 0.95)};
	};
	const std::int64_t found = searchCount(goalOf(1, 9173), errorOf);
	EXPECT_GE(found, fewest);
	EXPECT_LE(double(found), 1.15 * double(fewest)); // the least growth
	EXPECT_LE(trials, 5);
}

/// Errors are exponentially distributed: with two thirds of the exponent a twentieth is added.
TEST(SearchCount, FollowsTheShareOfVerticesThatCameIn)
{
	std::vector<std::int64_t> tried;
	const std::int64_t        found = searchCount(goalOf(1, 16000), [&](std::int64_t n) {
        tried.push_back(n);
        const auto added = std::int64_t(double(n) * std::exp(-double(n) / 4000));
        return ErrorTrial{n + added, 0.98, 0, added};
    });
	ASSERT_EQ(tried.size(), 2u);
	EXPECT_NEAR(double(tried[1]), 4000 * std::log(20), 100);
	EXPECT_EQ(found, tried[1]);
}

TEST(SearchCount, StopsWhereATwentiethCameIn)
{
	std::int64_t trialNum = 0;
	const auto   trial    = [&](std::int64_t n) {
        ++trialNum;
        return ErrorTrial{n + n / 20, 0.98, 0, n / 20};
	};
	EXPECT_EQ(searchCount(goalOf(1, 5000), trial), 5000);
	EXPECT_EQ(trialNum, 1);
}

/// A count of 1,000 misses the goal at a single place. All other counts from 600 on meet the goal.
TEST(SearchCount, GoesBelowACountThatMissedByChance)
{
	const std::int64_t found = searchCount(goalOf(1, 1000), [&](std::int64_t n) {
		if (n == 1000) return ErrorTrial{n, 1.02, 1e-5};
		return n < 600 ? ErrorTrial{n, 2, 0.05} : ErrorTrial{n, 0.5};
	});
	EXPECT_GE(found, 600);
	EXPECT_LT(found, 1000);
}

TEST(SearchCount, GivesUpAtTheMost)
{
	const Search search(goalOf(0.1, 900000), [](std::int64_t) { return 1.0; });
	EXPECT_EQ(search.found, 0);
	EXPECT_LE(search.trialNum, 5);
}

TEST(SearchCount, EndsAtTheLeastCountWhereAllMeetTheGoal)
{
	const Search search(goalOf(0.1, 100), [](std::int64_t) { return 0.0; });
	EXPECT_EQ(search.found, 4);
	int  trials = 0;
	auto found  = searchCount(goalOf(0.1, 100), [&](std::int64_t n) {
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
	EXPECT_NEAR(largestDistance(a, b, workers), 0.1, 0.003);
	EXPECT_EQ(largestDistance(a, b, workers), largestDistance(b, a, workers));
	EXPECT_NEAR(largestDistance(a, a, workers), 0, 1e-6);
}

TEST(SampledDistance, IsFoundInsideOfLargeFaces)
{
	Workers workers(2, nullptr);
	// A tent over the middle of two huge triangles, and a hole that only the other direction sees.
	TriangleMesh tent = grid(20, 20);
	for (Vec3d& p : tent.positions)
		p.z = std::max(0.0, 0.1 - length(p - Vec3d(0.7, 0.4, 0)));
	const HalfEdgeMesh flat = halfEdgesOf(grid(1, 1));
	EXPECT_NEAR(largestDistance(flat, halfEdgesOf(tent), workers), 0.1, 0.001);
	EXPECT_NEAR(largestDistance(flat, halfEdgesOf(squareFrame(20, 10)), workers), 0.25, 0.1);
}

TEST(SampledDistance, OverARampIsTheIntegral)
{
	for (const int cells : {1, 40}) {
		TriangleMesh tilted = grid(cells, cells);
		for (Vec3d& p : tilted.positions)
			p.z = 0.5 * p.x;
		Workers               workers(2, nullptr);
		const SurfaceDistance d =
			sampledBetween(halfEdgesOf(grid(60, 60)), halfEdgesOf(tilted), workers).mutual.toInput;
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
		sampledBetween(halfEdgesOf(grid(1, 1, 9, 9)), halfEdgesOf(mesh), workers).mutual;
	EXPECT_NEAR(d.toInput.p999, 0.1, 1e-3);
	EXPECT_NEAR(d.toInput.max, 0.2, 1e-6);
	EXPECT_EQ(d.larger().max, d.fromInput.max);
}

TEST(SampledDistance, IsTheSameForAnyNumberOfThreads)
{
	const HalfEdgeMesh a = halfEdgesOf(icosphere(5)), b = halfEdgesOf(torus(50, 20));
	Workers            alone(1, nullptr);
	const auto         one = sampledBetween(a, b, alone).mutual;
	for (const int threads : {2, 3}) {
		Workers    workers(threads, nullptr);
		const auto more = sampledBetween(a, b, workers).mutual;
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
		sampledBetween(HalfEdgeMesh(), halfEdgesOf(grid(2, 2)), workers).mutual;
	EXPECT_EQ(d.larger().max, 0);
	EXPECT_EQ(d.larger().p999, 0);
}

} // namespace gpr::test
