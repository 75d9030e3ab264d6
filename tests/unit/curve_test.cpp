// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/random_source.h>
#include <vcg_extras/core/surface/curve.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr double pi = 3.14159265358979323846;

/// A closed polyline through place(0), place(1/n), ...
Curve closedCurve(int n, const std::function<Vec3d(double)>& place)
{
	Curve c;
	for (int i = 0; i < n; ++i) {
		c.vertex.push_back(i);
		c.halfEdge.push_back(3 * i);
		c.point.push_back(Vec3f(place(double(i) / n)));
	}
	for (int i = 0; i < n; ++i) {
		c.arc.push_back(c.length);
		c.length += length(c.point[(i + 1) % n] - c.point[i]);
	}
	return c;
}

Vec3d circle(double t)
{
	return {std::cos(2 * pi * t), std::sin(2 * pi * t), 0};
}

/// Chords between the samples at from, the arcs and to.
std::vector<double> chords(const Curve& c, float from, float to, const std::vector<float>& arcs)
{
	std::vector<double> result;
	float               last = from;
	for (float s : arcs) {
		result.push_back(double(length(c.at(s) - c.at(last))));
		last = s;
	}
	result.push_back(double(length(c.at(to) - c.at(last))));
	return result;
}

double variation(const std::vector<double>& values)
{
	double sum = 0, squares = 0;
	for (double v : values) {
		sum += v;
		squares += v * v;
	}
	const double mean = sum / double(values.size());
	return std::sqrt(std::max(0.0, squares / double(values.size()) - mean * mean)) / mean;
}

double worstDeviation(const Curve& c, float from, float to, const std::vector<float>& arcs)
{
	float worst = 0, last = from;
	for (float s : arcs) {
		worst = std::max(worst, deviation(c, last, s));
		last  = s;
	}
	return double(std::max(worst, deviation(c, last, to)));
}

TEST(Curve, FindsPlacesByArcLength)
{
	// A square of side 1 by its corners.
	const Curve c = closedCurve(
		4, [](double t) { return Vec3d(t == 0.25 || t == 0.5 ? 1 : 0, t >= 0.5 ? 1 : 0, 0); });
	EXPECT_FLOAT_EQ(c.length, 4);
	EXPECT_FLOAT_EQ(c.wrap(4.5f), 0.5f);
	EXPECT_FLOAT_EQ(c.wrap(-0.5f), 3.5f);
	EXPECT_EQ(c.segmentAt(2.5f), 2);
	EXPECT_EQ(c.segmentAt(6.5f), 2);
	EXPECT_EQ(c.at(0.5f), Vec3f(0.5f, 0, 0));
	EXPECT_EQ(c.at(3.5f), Vec3f(0, 0.5f, 0)) << "on the way back to the first point";
	EXPECT_FLOAT_EQ(c.arcOf(1), 1);
	EXPECT_FLOAT_EQ(c.arcOf(5), 5);
	EXPECT_FLOAT_EQ(deviation(c, 0, 2), float(std::sqrt(0.5))) << "the corner between";
	EXPECT_FLOAT_EQ(deviation(c, 3.5f, 4.5f), float(std::sqrt(0.125))) << "over the start";
	EXPECT_FLOAT_EQ(deviation(c, 4.5f, 5.5f), float(std::sqrt(0.125))) << "on the second lap";
}

/// Rounding puts the end of a stretch beyond the end of the curve.
TEST(Curve, TheEndOfAnOpenCurveIsItsLastPoint)
{
	Curve c    = closedCurve(12, circle);
	c.isClosed = false;
	c.length   = c.arc.back();
	std::vector<float> arcs;
	forEachPointBetween(c, c.arc[8], std::nextafter(c.length, 10.0f),
						[&](const Vec3f&, float s) { arcs.push_back(s); });
	EXPECT_EQ(arcs, (std::vector<float>{c.arc[9], c.arc[10], c.arc[11]}));
}

TEST(SpaceOut, IsEvenOnACircleForAnyChord)
{
	const Curve c = closedCurve(2000, circle);
	for (float chord : {0.02f, 0.1f, 0.33f, 0.7f}) {
		const std::vector<float>  arcs  = spaceOut(c, 0, c.length, chord, 3);
		const std::vector<double> steps = chords(c, 0, c.length, arcs);
		EXPECT_LT(variation(steps), 0.01) << "chord " << chord;
		EXPECT_NEAR(double(steps.size()), 2 * pi / double(chord), 1.1);
		EXPECT_TRUE(std::is_sorted(arcs.begin(), arcs.end()));
		EXPECT_GT(arcs.front(), 0);
		EXPECT_LT(arcs.back(), c.length);
	}
}

TEST(SpaceOut, StartsAnywhereAndRunsOverTheEnd)
{
	const Curve c = closedCurve(500, circle);
	for (float from : {0.5f, 3.0f, 6.2f}) {
		const std::vector<float> arcs = spaceOut(c, from, from + 2, 0.2f, 1);
		EXPECT_LT(variation(chords(c, from, from + 2, arcs)), 0.01);
		for (float s : arcs)
			EXPECT_TRUE(s > from && s < from + 2);
	}
}

TEST(SpaceOut, MakesTheStepsAskedFor)
{
	const Curve c = closedCurve(500, circle);
	for (int steps = 1; steps <= 9; ++steps) {
		const float wanted =
			1.5f * 0.5f / float(steps); // fewer steps than asked for would fit better
		EXPECT_EQ(int(spaceOut(c, 1, 1.5f, wanted, steps).size()), steps - 1);
	}
}

/// Range maps end in rims that zigzag by less than the spacing: the polygon runs through the
/// middle.
TEST(SpaceOut, StaysWithinTheToleranceOfAFineZigzag)
{
	const float              chord = 0.1f;
	const Curve              c     = closedCurve(600, [](double t) {
        const double tooth = int(std::lround(t * 600)) % 2 == 0 ? 1.0025 : 0.9975;
        return circle(t) * tooth;
    });
	const std::vector<float> arcs  = spaceOut(c, 0, c.length, chord, 3);
	EXPECT_LE(worstDeviation(c, 0, c.length, arcs), 0.0801 * double(chord));
	EXPECT_LT(variation(chords(c, 0, c.length, arcs)), 0.05);
}

/// Teeth as long as the spacing can be followed; chords may then shrink to half and grow by half.
TEST(SpaceOut, FollowsTeethThatEvenSpacingWouldCutOff)
{
	const float              chord = 0.1f;
	const Curve              c     = closedCurve(1200, [](double t) {
        const double tooth = std::abs(std::remainder(t * 14, 1.0)); // 0 to 0.5, fourteen teeth
        return circle(t) * (1 + 0.5 * tooth);
    });
	const std::vector<float> arcs  = spaceOut(c, 0, c.length, chord, 3);
	EXPECT_LE(worstDeviation(c, 0, c.length, arcs), 0.12 * double(chord));
	for (double d : chords(c, 0, c.length, arcs)) {
		EXPECT_GE(d, 0.45 * double(chord));
		EXPECT_LE(d, 1.55 * double(chord));
	}
}

class RaggedCurve : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(RaggedCurve, IsNotDriftedFromAndGetsNoWildSteps)
{
	Random      random(GetParam());
	const Curve c = closedCurve(800, [&](double t) {
		return circle(t) * (1 + random.between(-0.004, 0.004) + 0.05 * std::sin(2 * pi * 9 * t));
	});
	for (float chord : {0.05f, 0.12f}) {
		const std::vector<float> arcs = spaceOut(c, 0, c.length, chord, 3);
		EXPECT_LE(worstDeviation(c, 0, c.length, arcs), 0.25 * double(chord)) << chord;
		EXPECT_LT(variation(chords(c, 0, c.length, arcs)), 0.3) << chord;
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, RaggedCurve, ::testing::ValuesIn(testSeeds(4)));

/// A ragged loop of 20000 points whose sizes differ a hundredfold: candidates and the chords tried
/// go by the size there, or this would take hours.
TEST(SpaceOut, GoesByTheLocalSizeOnDenseCurves)
{
	const int n = 20000;
	Curve c = closedCurve(n, [](double t) { return circle(t) * (1 + 2e-3 * std::sin(2e4 * t)); });
	for (int i = 0; i < n; ++i)
		c.size.push_back(i < n / 2 ? 1.0f : 0.01f);
	const std::vector<float> arcs = spaceOut(c, 0, c.length, 0.3f, 3);
	ASSERT_TRUE(std::is_sorted(arcs.begin(), arcs.end()));
	// Arcs are longer than the circle's by the zigzag, chords are not.
	EXPECT_GT(arcs.size(), 400u);
	EXPECT_LT(arcs.size(), 4000u);
	int coarse = 0;
	for (float s : arcs)
		coarse += s < 0.48f * c.length;
	EXPECT_GE(coarse, 6);
	EXPECT_LE(coarse, 30);
}

} // namespace

} // namespace gpr::test
