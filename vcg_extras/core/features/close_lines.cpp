// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "close_lines.h"

#include "boundary_curves.h"

#include <vcg_extras/core/base/angle.h>
#include <vcg_extras/core/surface/surface_ray.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <tuple>

namespace gpr {

namespace {

/// A stretch too close to another line goes on up to this many gaps.
constexpr float leaveRatio = 1.6f;
/// Lines diverge from their meeting point if their distance is at least this share of the way from
/// there.
constexpr float minSlope = 0.1f;
/// Beside a border this many gaps are too close: the border shows the trace of a dropped line.
constexpr float borderRatio = 2;
/// The cosine between the normals on both sides of a thin sheet is below this.
constexpr float maxSheetCosine = -0.5f;
/// The largest number of faces on a way across.
constexpr int maxCrossings = 500;

/// A way from the middle of a segment straight across the surface to another segment.
struct Crossing {
	int   from, to; ///< segments
	float distance; ///< divided by borderRatio beside a border
};

class CloseLines {
public:
	CloseLines(const Surface& surface, float gap, Workers& workers) :
			surface_(surface), m_(surface.mesh), gap_(gap), workers_(workers),
			curves_(traceCurves(m_, workers)), segmentAt_(std::size_t(m_.halfEdgeNum()))
	{
		numberSegments();
		findNodes();
		findCrossings();
	}

	std::vector<int> run()
	{
		decideAll();
		std::vector<int> close;
		for (std::size_t s = 0; s < halfEdge_.size(); ++s) {
			if (!isKept_[s]) close.push_back(std::min(halfEdge_[s], m_.opposite[halfEdge_[s]]));
		}
		std::sort(close.begin(), close.end());
		return close;
	}

private:
	const Surface&               surface_;
	const HalfEdgeMesh&          m_;
	float                        gap_;
	Workers&                     workers_;
	std::vector<Curve>           curves_;
	std::vector<int>             first_;     ///< per curve: its first segment; one more at the end
	std::vector<int>             halfEdge_;  ///< per segment
	std::vector<int>             curve_;     ///< per segment
	Buffer<int>                  segmentAt_; ///< per half-edge of a curve, for both halves
	std::map<int, std::set<int>> curvesAt_;  ///< per vertex: curves with an end there
	std::vector<std::vector<Crossing>> crossingsOf_; ///< per segment; each in both directions
	std::vector<char>                  isKept_;      ///< per segment

	/// Whether the curve goes on from a kept line, its strength, and minus the curve.
	using Candidate = std::tuple<bool, float, int>;
	std::priority_queue<Candidate> waiting_;

	// ---- segments

	void numberSegments()
	{
		for (int c = 0; c < int(curves_.size()); ++c) {
			first_.push_back(int(halfEdge_.size()));
			for (int h : curves_[c].halfEdge)
				addSegment(c, h);
		}
		first_.push_back(int(halfEdge_.size()));
	}

	void addSegment(int c, int h)
	{
		const int segment = int(halfEdge_.size());
		halfEdge_.push_back(h);
		curve_.push_back(c);
		isKept_.push_back(isBorder(c));
		segmentAt_[h] = segment;
		if (m_.opposite[h] >= 0) segmentAt_[m_.opposite[h]] = segment;
	}

	bool isBorder(int c) const { return m_.isBorderEdge(curves_[c].halfEdge[0]); }

	Vec3f middle(int s) const
	{
		const int h = halfEdge_[s];
		return (m_.position[m_.origin[h]] + m_.position[m_.target(h)]) * 0.5f;
	}

	float gapAt(int s) const
	{
		return surface_.size.empty() ? gap_ : gap_ * surface_.size[m_.origin[halfEdge_[s]]];
	}

	void findNodes()
	{
		for (int c = 0; c < int(curves_.size()); ++c) {
			const std::vector<int>& v = curves_[c].vertex;
			if (!curves_[c].isClosed) {
				curvesAt_[v.front()].insert(c);
				curvesAt_[v.back()].insert(c);
			}
			if (!isBorder(c)) continue;
			for (int w : v) {
				if (m_.isCreaseVertex(w)) curvesAt_[w].insert(c);
			}
		}
	}

	// ---- ways across

	void findCrossings()
	{
		const std::vector<Crossing> all =
			workers_.collectEach<Crossing>(halfEdge_.size(), [&](int s, auto& out) {
				for (int h : {halfEdge_[s], m_.opposite[halfEdge_[s]]})
					if (h >= 0) cross(h, s, out);
			});
		crossingsOf_.resize(halfEdge_.size());
		for (const Crossing& c : all) {
			crossingsOf_[c.from].push_back(c);
			crossingsOf_[c.to].push_back({c.to, c.from, c.distance});
		}
	}

	/// Adds the crossing from h to the first line within reach.
	void cross(int h, int segment, std::vector<Crossing>& out) const
	{
		const float reach = leaveRatio * borderRatio * gapAt(segment);
		bool        met   = false;
		traceRay(m_, h, {0, 1}, reach, maxCrossings, [&](int exit, float at) {
			if (met || !m_.isCurveEdge(exit)) return;
			met = true;
			if (isSheetBetween(h, exit)) return;
			const int  to       = segmentAt_[exit];
			const bool atBorder = isBorder(curve_[segment]) || isBorder(curve_[to]);
			out.push_back({segment, to, atBorder ? at / borderRatio : at});
		});
	}

	/// Whether a thin sheet lies between two lines: the faces beyond the lines look away from each
	/// other, and only the lines hold the two sides of the sheet apart.
	bool isSheetBetween(int h, int exit) const
	{
		const int f = m_.opposite[h], g = m_.opposite[exit];
		if (f < 0 || g < 0) return false;
		const Vec3f a = m_.faceCross(f / 3), b = m_.faceCross(g / 3);
		return dot(a, b) < maxSheetCosine * length(a) * length(b);
	}

	// ---- strength

	float strength(int c) const
	{
		float sum = 0;
		for (int s = first_[c]; s < first_[c + 1]; ++s) {
			const int   h = halfEdge_[s];
			const Vec3f a = m_.faceCross(h / 3), b = m_.faceCross(m_.opposite[h] / 3);
			sum += m_.edgeLength(h) * angleBetween(a, b);
		}
		return sum;
	}

	/// Always decides the strongest line that continues a kept line, or the strongest of all if
	/// none does. So the same side is kept all round a thin plate.
	void decideAll()
	{
		std::vector<char> isDecided;
		for (int c = 0; c < int(curves_.size()); ++c) {
			isDecided.push_back(isBorder(c));
			if (!isBorder(c)) waiting_.push({false, strength(c), -c});
		}
		while (!waiting_.empty()) {
			const int c = -std::get<int>(waiting_.top());
			waiting_.pop();
			if (isDecided[c]) continue;
			decide(c);
			isDecided[c] = 1;
			addThoseThatGoOn(c);
		}
	}

	void addThoseThatGoOn(int c)
	{
		if (curves_[c].isClosed) return;
		const std::vector<int>& v    = curves_[c].vertex;
		const std::vector<int>  ends = {v.front(), v.back()};
		for (int k : {0, 1}) {
			if (!isKept_[k == 0 ? first_[c] : first_[c + 1] - 1]) continue;
			for (int d : curvesAt_[ends[k]]) {
				if (!isBorder(d)) waiting_.push({true, strength(d), -d});
			}
		}
	}

	// ---- lines too close to others

	void decide(int c)
	{
		const int begin = first_[c], end = first_[c + 1];
		for (int s = begin; s < end; ++s)
			isKept_[s] = distanceFromKept(s) > gapAt(s);
		for (int s = begin + 1; s < end; ++s)
			leaveOut(s, s - 1);
		for (int s = end - 2; s >= begin; --s)
			leaveOut(s, s + 1);
	}

	/// Drops s with its neighbour if the line beside has not moved away yet.
	void leaveOut(int s, int neighbour)
	{
		if (isKept_[s] && !isKept_[neighbour] && distanceFromKept(s) <= leaveRatio * gapAt(s))
			isKept_[s] = 0;
	}

	float distanceFromKept(int s) const
	{
		float nearest = HUGE_VALF;
		for (const Crossing& c : crossingsOf_[s]) {
			if (c.distance < nearest && isKept_[c.to] && !diverge(c)) nearest = c.distance;
		}
		return nearest;
	}

	/// Whether the lines at both ends of the crossing diverge from a common point.
	bool diverge(const Crossing& x) const
	{
		const int c = curve_[x.from], d = curve_[x.to];
		if (c == d) return x.distance > minSlope * arcBetween(x);
		if (curves_[c].isClosed) return false;
		const std::vector<int>& v = curves_[c].vertex;
		for (int node : {v.front(), v.back()}) {
			if (curvesAt_.at(node).count(d) == 0) continue;
			if (x.distance > minSlope * length(middle(x.from) - m_.position[node])) return true;
		}
		return false;
	}

	float arcBetween(const Crossing& x) const
	{
		const int    c  = curve_[x.from];
		const Curve& on = curves_[c];
		return on.arcDistance(on.arc[x.from - first_[c]], on.arc[x.to - first_[c]]);
	}
};

} // namespace

std::vector<int> findCloseLines(const Surface& surface, float gap, Workers& workers)
{
	if (!surface.mesh.hasCreases()) return {};
	return CloseLines(surface, gap, workers).run();
}

} // namespace gpr
