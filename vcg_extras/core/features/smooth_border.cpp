// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_border.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gpr {

namespace {

/// Reach of the mean to either side, in wanted edges, and at most this share of the loop, so that
/// small holes keep their size.
constexpr float reachInEdges = 1.8f, largestShare = 0.25f;
/// Steps of the mean within its reach.
constexpr int stepsInReach = 12;
/// The largest distance of the smooth curve from the input's, in edges; the fit has the rest of the
/// slack.
constexpr float farthestOff = 0.35f;

float reachAt(const Curve& c, float edge, float s)
{
	return std::min(reachInEdges * edge * c.sizeAt(s), largestShare * c.length);
}

/// Evenly spaced points of a closed curve.
struct EvenLoop {
	float              step = 0;
	std::vector<Vec3f> point;

	EvenLoop(const Curve& c, float wantedStep)
	{
		const int num = std::max(2 * stepsInReach, int(std::ceil(c.length / wantedStep)));
		step          = c.length / float(num);
		for (int i = 0; i < num; ++i)
			point.push_back(c.at(float(i) * step));
	}

	int   size() const { return int(point.size()); }
	int   wrapped(int i) const { return (i % size() + size()) % size(); }
	Vec3f at(float s) const
	{
		const float x     = s / step;
		const int   i     = int(std::floor(x));
		const float share = x - float(i);
		return point[wrapped(i)] * (1 - share) + point[wrapped(i + 1)] * share;
	}

	/// The mean round point i, weighted by a bell of half width `reach`. No function of libm is
	/// used.
	Vec3f mean(int i, float reach) const
	{
		const int far = int(reach / step);
		Vec3f     sum;
		float     weights = 0;
		for (int k = -far; k <= far; ++k) {
			const float x      = float(k) * step / reach;
			const float left   = std::max(0.0f, 1 - x * x);
			const float weight = left * left * left;
			sum += point[wrapped(i + k)] * weight;
			weights += weight;
		}
		return sum * (1 / weights);
	}
};

void takeMeans(const Curve& c, float edge, EvenLoop& loop)
{
	std::vector<Vec3f> means(loop.point.size());
	for (int i = 0; i < loop.size(); ++i)
		means[i] = loop.mean(i, std::max(loop.step, reachAt(c, edge, float(i) * loop.step)));
	loop.point.swap(means);
}

/// Twice the mean, less the mean of the mean. A plain mean would draw a wide bend inwards; this
/// keeps it in place.
EvenLoop smoothed(const Curve& c, float edge)
{
	const float smallest = edge * c.smallestSize();
	EvenLoop    once(c, std::min(reachInEdges * smallest, largestShare * c.length) / stepsInReach);
	takeMeans(c, edge, once);
	EvenLoop twice = once;
	takeMeans(c, edge, twice);
	for (int i = 0; i < once.size(); ++i)
		once.point[i] = once.point[i] * 2.0f - twice.point[i];
	return once;
}

/// The point nearest to p on the segments of the curve within `reach` of point `begin`, along the
/// curve.
Vec3f nearestOnLoop(const Curve& c, int begin, float reach, const Vec3f& p)
{
	const int  n = c.pointNum();
	Vec3f      nearest;
	float      squared = HUGE_VALF;
	const auto look    = [&](int i) {
        const Vec3f a = c.point[i], b = c.point[(i + 1) % n];
        const Vec3f foot = a + (b - a) * shareOnSegment(p, a, b);
        if (squaredLength(p - foot) >= squared) return;
        squared = squaredLength(p - foot);
        nearest = foot;
	};
	look(begin);
	for (int direction : {-1, 1}) {
		for (int step = 1; step < n; ++step) {
			const int i = ((begin + direction * step) % n + n) % n;
			if (c.arcDistance(c.arc[i], c.arc[begin]) > reach) break;
			look(i);
		}
	}
	return nearest;
}

/// The new place of point i of the curve: its place on `loop`, or, if this is too far, the farthest
/// allowed point on the way there from the curve.
Vec3f placeNearCurve(const Curve& c, float edge, const EvenLoop& loop, int i)
{
	const float most = farthestOff * edge * c.sizeAt(c.arc[i]);
	const Vec3f goal = loop.at(c.arc[i]);
	if (length(goal - c.point[i]) <= most) return goal;
	const Vec3f foot = nearestOnLoop(c, i, reachAt(c, edge, c.arc[i]), goal);
	const float off  = length(goal - foot);
	return off <= most ? goal : foot + (goal - foot) * (most / off);
}

/// Per point of the loop: the arc length to the nearest fixed point.
std::vector<float> waysToFixed(const Curve& c, const std::vector<char>& isFixed)
{
	const int          n = c.pointNum();
	std::vector<float> way(n, HUGE_VALF);
	for (int i = 0; i < n; ++i) {
		if (isFixed[i]) way[i] = 0;
	}
	// Twice round, as the nearest fixed point may lie beyond the first point of the loop.
	for (int k = 1; k < 2 * n; ++k) {
		const int i = k % n, last = (k - 1) % n;
		way[i] = std::min(way[i], way[last] + c.lengthOf(last));
	}
	for (int k = 2 * n - 2; k >= 0; --k) {
		const int i = k % n, next = (k + 1) % n;
		way[i] = std::min(way[i], way[next] + c.lengthOf(i));
	}
	return way;
}

void measureArcs(Curve& c)
{
	const int n = c.pointNum();
	c.length    = 0;
	for (int i = 0; i < n; ++i) {
		c.arc[i] = c.length;
		c.length += length(c.point[(i + 1) % n] - c.point[i]);
	}
}

} // namespace

void smoothLoop(float edge, const std::vector<char>& isFixed, Curve& c)
{
	if (!(c.length > 0)) return;
	const EvenLoop           loop = smoothed(c, edge);
	const std::vector<float> way  = waysToFixed(c, isFixed);
	std::vector<Vec3f>       point;
	for (int i = 0; i < c.pointNum(); ++i) {
		const float share = std::min(1.0f, way[i] / (edge * c.sizeAt(c.arc[i])));
		point.push_back(c.point[i] + (placeNearCurve(c, edge, loop, i) - c.point[i]) * share);
	}
	c.point = std::move(point);
	measureArcs(c);
}

} // namespace gpr
