// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The p99.9 of counted distances, compared with a sort of all distances.
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/distance_histogram.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace gpr::test {

namespace {

/// How much too large the p99.9 may be.
constexpr double mostTooLarge = 0.0005;
/// Distances are counted as floats.
constexpr double rounding = 1e-7;

double largestOf(const std::vector<double>& distances)
{
	return distances.empty() ? 0 : *std::max_element(distances.begin(), distances.end());
}

double counted(const std::vector<double>& distances)
{
	DistanceHistogram histogram;
	for (const double d : distances)
		histogram.add(d);
	return histogram.p999(largestOf(distances));
}

/// The smallest distance with at most one distance in a thousand above.
double sorted(std::vector<double> distances)
{
	std::sort(distances.begin(), distances.end());
	return distances[distances.size() - 1 - distances.size() / 1000];
}

void expectWithinBound(double p999, double exact)
{
	EXPECT_GE(p999, exact * (1 - rounding));
	EXPECT_LE(p999, exact * (1 + mostTooLarge));
}

std::vector<double> randomDistances(std::size_t num, double unit)
{
	std::mt19937                    random(unsigned(num) + 7);
	std::exponential_distribution<> spread(3);
	std::vector<double>             distances(num);
	for (double& d : distances)
		d = unit * spread(random);
	return distances;
}

} // namespace

TEST(DistanceHistogram, IsWithinItsBoundOfASort)
{
	for (const std::size_t num : {1u, 2u, 999u, 1000u, 1001u, 1999u, 2000u, 12345u, 300000u}) {
		for (const double unit : {1e-30, 1e-6, 1.0, 777.0, 1e30}) {
			SCOPED_TRACE(std::to_string(num) + " distances, unit " + std::to_string(unit));
			const std::vector<double> distances = randomDistances(num, unit);
			expectWithinBound(counted(distances), sorted(distances));
			EXPECT_LE(counted(distances), largestOf(distances));
		}
	}
}

/// At the lower ends of bins, with the largest error of counting, below these ends, and between.
TEST(DistanceHistogram, IsWithinItsBoundEverywhereInABin)
{
	for (const int bin : {0, 1, 2, 777, 1023, 1024, 2046, 2047}) {
		const double low = 1 + bin / 2048.0;
		for (const double d : {low, std::nextafter(float(low), 0.0f) + 0.0, low + 1.0 / 5000}) {
			DistanceHistogram histogram;
			histogram.add(d, 999);
			histogram.add(1000);
			expectWithinBound(histogram.p999(1000), d);
		}
	}
}

TEST(DistanceHistogram, OfFewIsTheLargest)
{
	EXPECT_EQ(counted({}), 0);
	EXPECT_EQ(counted({0.3}), 0.3);
	EXPECT_EQ(counted({0.1, 0.7, 0.3}), 0.7);
	std::vector<double> distances(998, 0.25);
	distances.push_back(5);
	EXPECT_EQ(counted(distances), 5);
	distances.push_back(0.125);
	expectWithinBound(counted(distances), 0.25);
}

TEST(DistanceHistogram, OfEqualOnesIsExact)
{
	for (const double d : {0.0, 1e-30, 0.1, 1.0, 1 / 3.0, 12345.678})
		EXPECT_EQ(counted(std::vector<double>(2000, d)), d);
	std::vector<double> mostlyZero(2000, 0.0);
	mostlyZero[5] = 3;
	mostlyZero[6] = 4;
	EXPECT_EQ(counted(mostlyZero), 0);
	mostlyZero[7] = 2;
	expectWithinBound(counted(mostlyZero), 2);
}

TEST(DistanceHistogram, WeighsAsOftenAsAdded)
{
	std::mt19937        random(3);
	std::vector<double> distances;
	DistanceHistogram   histogram;
	for (int i = 0; i < 2000; ++i) {
		const double d      = std::uniform_real_distribution<>(0, 1)(random);
		const int    weight = int(random() % 50);
		histogram.add(d, weight);
		distances.insert(distances.end(), std::size_t(weight), d);
	}
	EXPECT_EQ(histogram.p999(largestOf(distances)), counted(distances));
	expectWithinBound(histogram.p999(largestOf(distances)), sorted(distances));
	DistanceHistogram large;
	large.add(1, std::int64_t(999) << 50);
	large.add(2, std::int64_t(1) << 50);
	expectWithinBound(large.p999(2), 1);
	large.add(2, std::int64_t(1) << 41);
	EXPECT_EQ(large.p999(2), 2);
}

TEST(DistanceHistogram, TakesWhatIsNoDistance)
{
	DistanceHistogram histogram;
	histogram.add(std::numeric_limits<double>::quiet_NaN());
	histogram.add(-1);
	histogram.add(1e-300);
	EXPECT_EQ(histogram.p999(1), 0);
	histogram.add(std::numeric_limits<double>::infinity());
	EXPECT_EQ(histogram.p999(std::numeric_limits<double>::infinity()),
			  double(std::numeric_limits<float>::max()));
}

TEST(DistanceHistogram, IsTheSameForAnyNumberOfThreads)
{
	const std::vector<double> distances = randomDistances(200000, 1);
	for (const int threads : {1, 2, 3}) {
		Workers           workers(threads, nullptr);
		DistanceHistogram histogram;
		workers.forEach(distances.size(),
						[&](int i) { histogram.add(distances[std::size_t(i)], i % 3 + 1); });
		DistanceHistogram alone;
		for (std::size_t i = 0; i < distances.size(); ++i)
			alone.add(distances[i], std::int64_t(i % 3 + 1));
		EXPECT_EQ(histogram.p999(largestOf(distances)), alone.p999(largestOf(distances)));
	}
}

} // namespace gpr::test
