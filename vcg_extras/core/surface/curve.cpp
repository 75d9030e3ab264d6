// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve.h"

#include <vcg_extras/core/base/sort_unique.h>

namespace gpr {

namespace {

float distanceToSegment(const Vec3f& p, const Vec3f& a, const Vec3f& b)
{
	return length(p - a - (b - a) * shareOnSegment(p, a, b));
}

/// A place of a curve, and the wanted size there.
struct Place {
	Vec3f position;
	float size;
};

Place placeAt(const Curve& c, float s)
{
	const float w      = c.wrap(s);
	const int   from   = c.segmentAt(w);
	const int   to     = (from + 1) % c.pointNum();
	const float extent = c.lengthOf(from);
	const float share  = extent > 0 ? std::clamp((w - c.arc[from]) / extent, 0.0f, 1.0f) : 0.0f;
	return {c.point[from] * (1 - share) + c.point[to] * share,
			c.size.empty() ? 1 : c.size[from] * (1 - share) + c.size[to] * share};
}

/// Straight distance of two places over the wanted size between both.
float relativeChord(const Place& p, const Place& q)
{
	return length(q.position - p.position) / (0.5f * (p.size + q.size));
}

/// Goes from arc a to b by chords of length d: each step ends at the first point at distance d from
/// the step's begin. Returns the steps made, with the fraction left over; appends the arcs if
/// asked.
float march(const Curve& c, float a, float b, float d, std::vector<float>* arcs)
{
	float from  = a;
	float steps = 0;
	while (true) {
		const Place start  = placeAt(c, from);
		const float stride = d * 0.1f * start.size;
		float       s      = from;
		float       before = 0;
		bool        found  = false;
		while (s < b) {
			const float next = std::min(b, s + stride);
			const float far  = relativeChord(start, placeAt(c, next));
			if (far >= d) {
				s += (next - s) * (d - before) / std::max(far - before, 1e-30f);
				found = true;
				break;
			}
			before = far;
			if (!(next > s)) break;
			s = next;
		}
		if (!found || !(s > from)) return steps + relativeChord(start, placeAt(c, b)) / d;
		from = s;
		steps += 1;
		if (arcs != nullptr) arcs->push_back(s);
	}
}

/// Exactly `steps` chords of the same length, found by bisection.
std::vector<float> evenSpacing(const Curve& c, float a, float b, float d, int steps)
{
	std::vector<float> arcs;
	if (steps < 2) return arcs;
	if (steps == 2) return {0.5f * (a + b)};
	float low = 0.3f * d, high = 3 * d;
	for (int round = 0; round < 18; ++round) {
		const float middle                                            = 0.5f * (low + high);
		(march(c, a, b, middle, nullptr) > float(steps) ? low : high) = middle;
	}
	march(c, a, b, high, &arcs);
	arcs.resize(std::min<std::size_t>(arcs.size(), steps - 1));
	return arcs;
}

/// Largest distance of the curve's points between arcs a and b from the chord from p to q.
float deviationBetween(const Curve& c, float a, float b, const Vec3f& p, const Vec3f& q)
{
	float worst = 0;
	forEachPointBetween(c, a, b, [&](const Vec3f& point, float) {
		worst = std::max(worst, distanceToSegment(point, p, q));
	});
	return worst;
}

/// deviation() over the wanted size there.
float relativeDeviation(const Curve& c, float a, float b)
{
	return deviation(c, a, b) / (0.5f * (c.sizeAt(a) + c.sizeAt(b)));
}

float worstDeviation(const Curve& c, float a, float b, const std::vector<float>& arcs)
{
	float worst = 0, last = a;
	for (float s : arcs) {
		worst = std::max(worst, relativeDeviation(c, last, s));
		last  = s;
	}
	return std::max(worst, relativeDeviation(c, last, b));
}

/// Arcs a tenth of the wanted chord apart, from a to b, both included.
std::vector<float> spreadArcs(const Curve& c, float a, float b, float d)
{
	std::vector<float> arcs;
	if (c.size.empty()) {
		const int n = std::max(1, int(std::ceil((b - a) / (0.1f * d))));
		for (int i = 0; i < n; ++i)
			arcs.push_back(a + (b - a) * float(i) / float(n));
	}
	else {
		const float least = 1e-6f * (b - a); // rounding must not stop the way
		for (float s = a; s < b; s += std::max(least, 0.1f * d * c.sizeAt(s)))
			arcs.push_back(s);
	}
	arcs.push_back(b);
	return arcs;
}

/// Arcs of the curve's own points and evenly spread arcs, from a to b, both included.
std::vector<float> candidateArcs(const Curve& c, float a, float b, float d)
{
	std::vector<float> arcs = spreadArcs(c, a, b, d);
	// Points at bends of the curve belong to the best polygon; dense points add nothing.
	float last = a;
	forEachPointBetween(c, a, b, [&](const Vec3f&, float s) {
		if (!(s - last > 0.05f * d * c.sizeAt(s))) return;
		arcs.push_back(s);
		last = s;
	});
	sortUnique(arcs);
	return arcs;
}

/// The chain of chords of least cost from the first to the last candidate.
std::vector<float> cheapestSpacing(const Curve& c, float a, float b, float d)
{
	constexpr float shortest = 0.3f, longest = 1.5f; // of the wanted chord
	// An excess of a sixth costs as much as a chord two thirds too short.
	constexpr double excessWeight = 16;

	const std::vector<float> arcs = candidateArcs(c, a, b, d);
	const int                n    = int(arcs.size());
	std::vector<Place>       place(n);
	for (int i = 0; i < n; ++i)
		place[i] = placeAt(c, arcs[i]);

	std::vector<double> cost(n, HUGE_VAL);
	std::vector<int>    before(n, -1);
	cost[0] = 0;
	for (int i = 1; i < n; ++i) {
		for (int k = i - 1; k >= 0; --k) {
			const Place &p = place[k], &q = place[i];
			// A chord is never longer than its arc; beyond this arc length no chord is worth a
			// look.
			const float size = std::max(q.size, p.size);
			if (arcs[i] - arcs[k] > 3 * longest * d * size && before[i] >= 0) break;
			const float chord = relativeChord(p, q) / d;
			const bool  isEnd = i == n - 1 || k == 0;
			if (chord > longest && before[i] >= 0) continue;
			if (chord < shortest && !isEnd) continue;
			const double byLength = double(chord - 1) * (chord - 1);
			// Fast since most chords lose by their length alone: only the others are measured
			// against all points of the curve.
			if (!(cost[k] + byLength < cost[i])) continue;
			const float away = deviationBetween(c, arcs[k], arcs[i], p.position, q.position) /
							   (0.5f * (p.size + q.size));
			const float  excess = away / (curveTolerance * d) - 1;
			const double total =
				cost[k] + (byLength + (excess > 0 ? excessWeight * double(excess) * excess : 0.0));
			if (total < cost[i]) {
				cost[i]   = total;
				before[i] = k;
			}
		}
	}
	std::vector<float> chosen;
	for (int i = before[n - 1]; i > 0; i = before[i])
		chosen.push_back(arcs[i]);
	std::reverse(chosen.begin(), chosen.end());
	return chosen;
}

} // namespace

float Curve::wrap(float s) const
{
	if (!(length > 0)) return 0;
	if (!isClosed) return std::clamp(s, 0.0f, length);
	while (s < 0)
		s += length;
	while (s >= length)
		s -= length;
	return s;
}

int Curve::segmentAt(float s) const
{
	const auto above = std::upper_bound(arc.begin(), arc.end(), wrap(s));
	const int  last  = isClosed ? pointNum() - 1 : pointNum() - 2;
	return std::clamp(int(above - arc.begin()) - 1, 0, last);
}

Vec3f Curve::at(float s) const
{
	return placeAt(*this, s).position;
}

float Curve::sizeAt(float s) const
{
	return size.empty() ? 1 : placeAt(*this, s).size;
}

float Curve::smallestSize() const
{
	return size.empty() ? 1.0f : *std::min_element(size.begin(), size.end());
}

float deviation(const Curve& c, float a, float b)
{
	return deviationBetween(c, a, b, c.at(a), c.at(b));
}

std::vector<float> spaceOut(const Curve& curve, float from, float to, float d, int minSteps)
{
	const int steps = std::max(minSteps, int(std::lround(march(curve, from, to, d, nullptr))));
	std::vector<float> even = evenSpacing(curve, from, to, d, steps);
	if (worstDeviation(curve, from, to, even) <= curveTolerance * d) return even;
	std::vector<float> fitted = cheapestSpacing(curve, from, to, d);
	return int(fitted.size()) + 1 >= minSteps ? fitted : even;
}

} // namespace gpr
