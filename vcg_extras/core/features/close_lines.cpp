// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "close_lines.h"

#include "boundary_curves.h"
#include "crease_clearance.h"

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

/// An edge of a curve.
struct Segment {
	int                   halfEdge;
	int                   curve;
	bool                  isKept;
	std::vector<Crossing> crossings = {}; ///< from here
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
		for (const Segment& s : segment_) {
			if (!s.isKept) close.push_back(std::min(s.halfEdge, m_.opposite[s.halfEdge]));
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
	std::vector<Segment>         segment_;   ///< curve by curve
	std::vector<int>             first_;     ///< per curve: its first segment; one more at the end
	Buffer<int>                  segmentAt_; ///< per half-edge of a curve, for both halves
	std::map<int, std::set<int>> curvesAt_;  ///< per vertex: curves with an end there

	/// Whether the curve goes on from a kept line, its strength, and minus the curve.
	using Candidate = std::tuple<bool, float, int>;
	std::priority_queue<Candidate> waiting_;

	// ---- segments

	void numberSegments()
	{
		for (int c = 0; c < int(curves_.size()); ++c) {
			first_.push_back(int(segment_.size()));
			for (int h : curves_[c].halfEdge) {
				segmentAt_[h] = int(segment_.size());
				if (m_.opposite[h] >= 0) segmentAt_[m_.opposite[h]] = segmentAt_[h];
				segment_.push_back({h, c, isBorder(c)});
			}
		}
		first_.push_back(int(segment_.size()));
	}

	bool isBorder(int c) const { return m_.isBorderEdge(curves_[c].halfEdge[0]); }

	Vec3f middle(int s) const
	{
		const int h = segment_[s].halfEdge;
		return (m_.position[m_.origin[h]] + m_.position[m_.target(h)]) * 0.5f;
	}

	float gapAt(int s) const
	{
		return surface_.size.empty() ? gap_ : gap_ * surface_.size[m_.origin[segment_[s].halfEdge]];
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
			workers_.collectEach<Crossing>(segment_.size(), [&](int s, auto& out) {
				for (int h : {segment_[s].halfEdge, m_.opposite[segment_[s].halfEdge]})
					if (h >= 0) cross(h, s, out);
			});
		for (const Crossing& c : all) {
			segment_[c.from].crossings.push_back(c);
			segment_[c.to].crossings.push_back({c.to, c.from, c.distance});
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
			const bool atBorder = isBorder(segment_[segment].curve) || isBorder(segment_[to].curve);
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
			const int h = segment_[s].halfEdge;
			sum += m_.edgeLength(h) * dihedralAngle(m_, h);
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
			if (!segment_[k == 0 ? first_[c] : first_[c + 1] - 1].isKept) continue;
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
			segment_[s].isKept = distanceFromKept(s) > gapAt(s);
		for (int s = begin + 1; s < end; ++s)
			leaveOut(s, s - 1);
		for (int s = end - 2; s >= begin; --s)
			leaveOut(s, s + 1);
	}

	/// Drops s with its neighbour if the line beside has not moved away yet.
	void leaveOut(int s, int neighbour)
	{
		if (segment_[s].isKept && !segment_[neighbour].isKept &&
			distanceFromKept(s) <= leaveRatio * gapAt(s))
			segment_[s].isKept = false;
	}

	float distanceFromKept(int s) const
	{
		float nearest = HUGE_VALF;
		for (const Crossing& c : segment_[s].crossings) {
			if (c.distance < nearest && segment_[c.to].isKept && !diverge(c)) nearest = c.distance;
		}
		return nearest;
	}

	/// Whether the lines at both ends of the crossing diverge from a common point.
	bool diverge(const Crossing& x) const
	{
		const int c = segment_[x.from].curve, d = segment_[x.to].curve;
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
		const int    c  = segment_[x.from].curve;
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
