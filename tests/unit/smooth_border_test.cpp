// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/oracles.h>
#include <vcg_extras/core/features/smooth_border.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr double pi = 3.14159265358979323846;

Curve closedCurve(int n, const std::function<Vec3d(int)>& place)
{
	Curve c;
	for (int i = 0; i < n; ++i) {
		c.vertex.push_back(i);
		c.halfEdge.push_back(3 * i);
		c.point.push_back(Vec3f(place(i)));
	}
	for (int i = 0; i < n; ++i) {
		c.arc.push_back(c.length);
		c.length += length(c.point[(i + 1) % n] - c.point[i]);
	}
	return c;
}

/// A circle whose every second point lies farther out by `tooth`.
Curve toothedCircle(int n, double radius, double tooth)
{
	return closedCurve(n, [&](int i) {
		const double r = radius + (i % 2) * tooth, turn = 2 * pi * i / n;
		return Vec3d(r * std::cos(turn), r * std::sin(turn), 0);
	});
}

Curve smooth(Curve c, float edge, const std::vector<int>& fixed = {})
{
	std::vector<char> isFixed(c.point.size(), 0);
	for (int i : fixed)
		isFixed[i] = 1;
	smoothLoop(edge, isFixed, c);
	return c;
}

double distanceToCurve(const Curve& c, const Vec3f& p)
{
	double nearest = HUGE_VAL;
	for (int i = 0; i < c.pointNum(); ++i) {
		const Vec3f& next = c.point[(i + 1) % c.pointNum()];
		nearest = std::min(nearest, distanceToSegment(Vec3d(p), Vec3d(c.point[i]), Vec3d(next)));
	}
	return nearest;
}

TEST(SmoothLoop, TeethGoAndTheCircleStays)
{
	const Curve ragged = toothedCircle(400, 10, 0.3);
	const Curve c      = smooth(ragged, 1);
	for (const Vec3f& p : c.point)
		EXPECT_NEAR(length(p), 10.15, 0.05);
	EXPECT_LT(c.length, 0.8 * ragged.length);
	EXPECT_NEAR(c.length, 2 * pi * 10.15, 0.3);
}

TEST(SmoothLoop, ArcsAreThoseOfTheSmoothCurve)
{
	const Curve c = smooth(toothedCircle(60, 5, 0.4), 1);
	float       s = 0;
	for (int i = 0; i < c.pointNum(); ++i) {
		EXPECT_FLOAT_EQ(c.arc[i], s);
		s += length(c.point[(i + 1) % c.pointNum()] - c.point[i]);
	}
	EXPECT_FLOAT_EQ(c.length, s);
}

TEST(SmoothLoop, SmallHolesKeepTheirSize)
{
	for (double radius : {0.3, 1.0, 2.0, 5.0}) {
		const Curve c = smooth(toothedCircle(100, radius, 0), 1);
		for (const Vec3f& p : c.point)
			EXPECT_NEAR(length(p), radius, 0.03 * radius) << radius;
	}
}

TEST(SmoothLoop, StaysWithinTheSlack)
{
	// Too long for the mean to follow, and deeper than the slack.
	const Curve star = closedCurve(300, [](int i) {
		const double turn = 2 * pi * i / 300, r = 10 + 4 * std::sin(20 * turn);
		return Vec3d(r * std::cos(turn), r * std::sin(turn), 0);
	});
	for (float edge : {0.5f, 1.0f, 3.0f}) {
		const Curve c   = smooth(star, edge);
		double      far = 0;
		for (const Vec3f& p : c.point)
			far = std::max(far, distanceToCurve(star, p));
		EXPECT_LE(far, double(borderSlack * edge));
		EXPECT_GT(far, 0.02 * double(edge));
	}
}

TEST(SmoothLoop, FixedPointsStay)
{
	const Curve ragged = toothedCircle(400, 10, 0.3);
	const Curve c      = smooth(ragged, 1, {0, 151});
	EXPECT_EQ(length(c.point[0] - ragged.point[0]), 0);
	EXPECT_EQ(length(c.point[151] - ragged.point[151]), 0);
	EXPECT_GT(length(c.point[75] - ragged.point[75]), 0.1);
}

TEST(SmoothLoop, FollowsSizes)
{
	Curve ragged = toothedCircle(400, 10, 0.3);
	ragged.size.assign(400, 0.05f);
	const Curve c = smooth(ragged, 1);
	for (int i = 0; i < c.pointNum(); ++i)
		EXPECT_LT(length(c.point[i] - ragged.point[i]), borderSlack * 0.05f);
}

} // namespace

} // namespace gpr::test
