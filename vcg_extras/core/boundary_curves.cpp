// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary_curves.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

constexpr float cornerTurn = 50 * 3.14159265f / 180;

/// The border half-edge that follows h: turn about its head until the border is met again.
int nextOnBorder(const HalfEdgeMesh& m, int h)
{
	int x = nextInFace(h);
	while (m.opposite[x] >= 0)
		x = nextInFace(m.opposite[x]);
	return x;
}

Curve traceLoop(const HalfEdgeMesh& m, int first, std::vector<char>& seen)
{
	Curve c;
	int   h = first;
	do {
		seen[m.origin[h]] = 1;
		c.vertex.push_back(m.origin[h]);
		c.point.push_back(m.position[m.origin[h]]);
		c.face.push_back(h / 3);
		c.arc.push_back(c.length);
		c.length += length(m.position[m.target(h)] - m.position[m.origin[h]]);
		h = nextOnBorder(m, h);
	} while (h != first);
	return c;
}

std::vector<Curve> traceBorder(const HalfEdgeMesh& m)
{
	std::vector<Curve> curves;
	std::vector<char>  seen(m.vertexNum, 0);
	for (int v = 0; v < m.vertexNum; ++v) {
		const int h = m.outgoing[v];
		if (h < 0 || m.opposite[h] >= 0 || seen[v]) continue;
		curves.push_back(traceLoop(m, h, seen));
	}
	return curves;
}

/// Angle between the chords to the points `window` before and behind. Vertex angles themselves say
/// nothing on the zigzag rims of range maps.
std::vector<float> turnsOver(const Curve& c, float window)
{
	std::vector<float> turn(c.pointNum());
	for (int i = 0; i < c.pointNum(); ++i) {
		const Vec3f in  = c.point[i] - c.at(c.arc[i] - window);
		const Vec3f out = c.at(c.arc[i] + window) - c.point[i];
		turn[i]         = std::atan2(length(cross(in, out)), dot(in, out));
	}
	return turn;
}

/// Whether no point within `window` along the curve turns more (ties: the first one wins).
bool isLargestTurn(const Curve& c, const std::vector<float>& turn, int i, float window)
{
	const int n = c.pointNum();
	for (int direction : {-1, 1}) {
		int   k    = i;
		float walk = 0;
		while (true) {
			const int next = (k + direction + n) % n;
			walk += length(c.point[next] - c.point[k]);
			k = next;
			if (walk > window || k == i) break;
			if (turn[k] > turn[i] || (turn[k] == turn[i] && k < i)) return false;
		}
	}
	return true;
}

/// Arcs of the corners; for a loop without any, of the sharpest turn, so that there is a start.
std::vector<float> findCorners(const Curve& c, float diskRadius, bool& hasCorners)
{
	const float              window = std::min(diskRadius, c.length / 6);
	const std::vector<float> turn   = turnsOver(c, window);
	std::vector<float>       arcs;
	for (int i = 0; i < c.pointNum(); ++i) {
		if (turn[i] > cornerTurn && isLargestTurn(c, turn, i, window)) arcs.push_back(c.arc[i]);
	}
	hasCorners = !arcs.empty();
	if (arcs.empty()) {
		const auto sharpest = std::max_element(turn.begin(), turn.end());
		arcs.push_back(c.arc[sharpest - turn.begin()]);
	}
	return arcs;
}

class LoopSampler {
public:
	LoopSampler(const Curve& c, int index, std::vector<CurveSample>& out) :
			c_(c), index_(index), out_(out)
	{
	}

	/// Three of the loop's own vertices, as even as possible.
	void keepThree()
	{
		std::vector<char> taken(c_.pointNum(), 0);
		for (int k = 0; k < 3; ++k) {
			const float wanted = c_.length * float(k) / 3;
			int         best   = -1;
			for (int i = 0; i < c_.pointNum(); ++i) {
				if (taken[i]) continue;
				if (best < 0 || std::abs(c_.arc[i] - wanted) < std::abs(c_.arc[best] - wanted)) {
					best = i;
				}
			}
			taken[best] = 1;
			put(c_.arc[best], true);
		}
	}

	void sample(float diskRadius, const CurveSpacing& spacing)
	{
		bool                     hasCorners = false;
		const std::vector<float> corners    = findCorners(c_, diskRadius, hasCorners);
		const int                n          = int(corners.size());
		// However few the corners, three samples must come out.
		const int minSteps = n == 1 ? 3 : n == 2 ? 2 : 1;
		for (int i = 0; i < n; ++i) {
			const float from = corners[i];
			const float to   = i + 1 < n ? corners[i + 1] : corners[0] + c_.length;
			put(from, hasCorners);
			for (float s : spaceOut(c_, from, to, spacing, minSteps))
				put(s, false);
		}
	}

private:
	const Curve&              c_;
	int                       index_;
	std::vector<CurveSample>& out_;

	void put(float s, bool isCorner)
	{
		CurveSample sample;
		sample.arc      = c_.wrap(s);
		sample.curve    = index_;
		sample.isCorner = isCorner;
		sample.anchor   = {c_.at(sample.arc), c_.face[c_.segmentAt(sample.arc)]};
		out_.push_back(sample);
	}
};

/// Distance along a closed curve.
float arcDistance(const Curve& c, float a, float b)
{
	const float d = std::abs(a - b);
	return std::min(d, c.length - d);
}

/// Nearest of the samples [begin, end), sorted by arc, to arc s.
int nearestSample(const Curve& c, const std::vector<CurveSample>& samples, int begin, int end,
				  float s)
{
	const auto above = std::lower_bound(samples.begin() + begin, samples.begin() + end, s,
										[](const CurveSample& a, float x) { return a.arc < x; });
	const int  n     = end - begin;
	const int  high  = int(above - samples.begin()) - begin;
	const int  next = begin + high % n, last = begin + (high + n - 1) % n;
	return arcDistance(c, samples[next].arc, s) < arcDistance(c, samples[last].arc, s) ? next
																					   : last;
}

/// Gives every point of the curve its sample, and every sample the nearest of its points.
std::vector<int> assignPoints(const Curve& c, std::vector<CurveSample>& samples, int begin)
{
	std::vector<int>   owner(c.pointNum());
	std::vector<float> distance(samples.size() - begin, HUGE_VALF);
	for (int i = 0; i < c.pointNum(); ++i) {
		const int s   = nearestSample(c, samples, begin, int(samples.size()), c.arc[i]);
		owner[i]      = s;
		const float d = arcDistance(c, samples[s].arc, c.arc[i]);
		if (d < distance[s - begin]) {
			distance[s - begin] = d;
			samples[s].vertex   = c.vertex[i];
		}
	}
	return owner;
}

} // namespace

BoundaryCurves sampleBoundary(const Surface& surface, float diskRadius, float spacing)
{
	BoundaryCurves result;
	result.curves = traceBorder(surface.mesh);
	CurveSpacing wanted;
	wanted.chord = spacing;
	for (std::size_t i = 0; i < result.curves.size(); ++i) {
		const Curve& c     = result.curves[i];
		const int    begin = int(result.samples.size());
		LoopSampler  sampler(c, int(i), result.samples);
		if (c.pointNum() <= 3 || c.length < 1.8f * spacing) {
			sampler.keepThree();
		}
		else {
			sampler.sample(diskRadius, wanted);
		}
		std::sort(result.samples.begin() + begin, result.samples.end(),
				  [](const CurveSample& a, const CurveSample& b) { return a.arc < b.arc; });
		result.sampleOfPoint.push_back(assignPoints(c, result.samples, begin));
	}
	return result;
}

} // namespace gpr
