// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_fit.h"

#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/edit/move_guard.h>
#include <vcg_extras/core/features/curve_slide.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gpr {

namespace {

/// The mean distance is stable after these rounds: 2 rounds are 0.1 % worse, 8 are no better (means
/// of six models).
constexpr int rounds = 4;
/// Share of the way to the minimum with fixed neighbours. The whole way would leave every second
/// vertex far out: a vertex would move for its neighbours, and the neighbours then need not move.
constexpr float stepLength = 0.6f;
/// Pull to the start of the vertex, as a share of the weight of its edges.
constexpr float pullBack = 0.05f;
/// A piece of the curve at this distance, in wanted edges, weighs twice, so that the largest
/// distance falls, too.
constexpr float noticeable = 0.1f;
/// Largest distance of a vertex from the curve, in wanted edges.
constexpr float farthestOff = 0.08f;
/// Longest pieces of the curve for sums along the curve, in wanted edges.
constexpr float longestPiece = 0.1f;
/// Shares of a move, tried in order.
constexpr float moveShares[] = {1, 0.5f, 0.25f};

/// The point of a segment nearest to p, and its share of the way to b.
struct Foot {
	float share;
	Vec3f way; ///< to p
};

Foot footOn(const Vec3f& p, const Vec3f& a, const Vec3f& b)
{
	const float share = shareOnSegment(p, a, b);
	return {share, p - a - (b - a) * share};
}

/// The part of a curve between the two neighbours of a vertex on the curve. The two edges at the
/// vertex answer for the part.
struct Span {
	Vec3f              first, last; ///< the neighbours
	float              from = 0;    ///< arc at `first`
	float              edge = 0;    ///< wanted edge length
	std::vector<Vec3f> point;       ///< of the curve, ends included
	std::vector<float> arc;         ///< at each point, counted from `from`
};

class CurveFitter {
public:
	CurveFitter(const Surface& surface, const BoundaryCurves& curves, float minAngle, CurveFit goal,
				ResultMesh& result, Workers& workers) :
			surface_(surface),
			curves_(curves), limits_(acceptanceOf(Driver::CurveFit, minAngle)), goal_(goal),
			r_(result), m_(result.mesh), workers_(workers)
	{
	}

	void run()
	{
		for (int v = 0; v < m_.vertexNum; ++v) {
			const bool isOnCurve = constraintOf(r_, v) == Constraint::Curve;
			if (isOnCurve && slideRoom(r_, curves_, v).isOpen()) vertices_.push_back(v);
		}
		std::vector<Vec3f> start;
		for (int v : vertices_)
			start.push_back(m_.position[v]);
		for (int round = 0; round < rounds; ++round) {
			for (std::size_t i = 0; i < vertices_.size(); ++i) {
				workers_.poll();
				fit(vertices_[i], start[i]);
			}
		}
		for (int v : vertices_) {
			workers_.poll();
			follow(v);
		}
	}

private:
	const Surface&        surface_;
	const BoundaryCurves& curves_;
	Acceptance            limits_;
	CurveFit              goal_;
	ResultMesh&           r_;
	HalfEdgeMesh&         m_;
	Workers&              workers_;
	std::vector<int>      vertices_;
	Span                  span_; ///< of the vertex at hand

	void fit(int v, const Vec3f& start)
	{
		if (!findSpan(v)) return;
		const Vec3f from = m_.position[v];
		const Vec3f way  = wayToMinimum(from, start);
		const float far  = goal_ == CurveFit::Mean ? HUGE_VALF : farthest(from);
		const float off  = std::max(farthestOff * span_.edge, offCurve(from));
		for (float share : moveShares) {
			const Vec3f to     = from + way * share;
			const bool  isNear = offCurve(to) <= off && farthest(to) <= far;
			if (!isNear || spoilsRing(limits_, m_, v, to)) continue;
			m_.position[v] = to;
			return;
		}
	}

	/// False if the curve does not bend: then the vertex needs no fit.
	bool findSpan(int v)
	{
		const SlideRoom room = slideRoom(r_, curves_, v);
		const Curve&    c    = curves_.curves[r_.vertex[v].curve];
		const float     arc = r_.vertex[v].arc, a = arc - room.backward, b = arc + room.forward;
		// On a closed curve the span may begin before its first point.
		const float lap = a < 0 ? c.length : 0.0f;
		span_.first     = m_.position[room.last];
		span_.last      = m_.position[room.next];
		span_.from      = a;
		span_.edge      = r_.idealEdge * c.sizeAt(arc);
		span_.point.assign(1, c.at(a + lap));
		span_.arc.assign(1, 0.0f);
		forEachPointBetween(c, a + lap, b + lap, [&](const Vec3f& p, float s) {
			span_.point.push_back(p);
			span_.arc.push_back(s - a - lap);
		});
		span_.point.push_back(c.at(b + lap));
		span_.arc.push_back(b - a);
		return span_.point.size() > 2;
	}

	/// Calls visit(p, extent) for pieces of the span, p in the middle of each.
	template <class Visit>
	void forEachPiece(const Visit& visit) const
	{
		for (std::size_t i = 1; i < span_.point.size(); ++i) {
			const Vec3f a = span_.point[i - 1], b = span_.point[i];
			const float extent = length(b - a);
			const int   num    = 1 + int(extent / (longestPiece * span_.edge));
			for (int k = 0; k < num; ++k)
				visit(a + (b - a) * ((float(k) + 0.5f) / float(num)), extent / float(num));
		}
	}

	/// The damped way of x to the minimum of the squared distances of the pieces from the two edges
	/// by x, with the present feet on the edges.
	Vec3f wayToMinimum(const Vec3f& x, const Vec3f& start) const
	{
		const float scale = 1 / (noticeable * span_.edge);
		Vec3f       force;
		float       stiff = 0;
		forEachPiece([&](const Vec3f& p, float extent) {
			const Foot  a = footOn(p, span_.first, x), b = footOn(p, span_.last, x);
			const Foot& foot   = squaredLength(a.way) < squaredLength(b.way) ? a : b;
			const float weight = extent * (1 + squaredLength(foot.way * scale));
			force += foot.way * (weight * foot.share);
			stiff += weight * foot.share * foot.share;
		});
		if (!(stiff > 0)) return Vec3f();
		return (force * (1 / stiff) + (start - x) * pullBack) * (stepLength / (1 + pullBack));
	}

	/// The point of the span nearest to p.
	struct Nearest {
		float squaredOff = HUGE_VALF;
		float arc        = 0; ///< from the begin of the span
	};

	Nearest nearestTo(const Vec3f& p) const
	{
		Nearest nearest;
		for (std::size_t i = 1; i < span_.point.size(); ++i) {
			const Foot  foot    = footOn(p, span_.point[i - 1], span_.point[i]);
			const float squared = squaredLength(foot.way);
			if (squared >= nearest.squaredOff) continue;
			nearest = {squared, span_.arc[i - 1] + foot.share * (span_.arc[i] - span_.arc[i - 1])};
		}
		return nearest;
	}

	float offCurve(const Vec3f& p) const { return std::sqrt(nearestTo(p).squaredOff); }

	/// Largest squared distance between the curve and the edges by x, which is always at a point of
	/// the curve or at x.
	float farthest(const Vec3f& x) const
	{
		float far = nearestTo(x).squaredOff;
		for (const Vec3f& p : span_.point)
			far = std::max(far, std::min(squaredLength(footOn(p, span_.first, x).way),
										 squaredLength(footOn(p, span_.last, x).way)));
		return far;
	}

	/// Slides the record to the point of the curve nearest to the vertex.
	void follow(int v)
	{
		if (!findSpan(v)) return;
		const float         arc  = nearestTo(m_.position[v]).arc;
		const ResultVertex& here = r_.vertex[v];
		r_.vertex[v]             = slid(surface_, curves_, here, span_.from + arc - here.arc);
	}
};

} // namespace

void fitCurves(const Surface& surface, const BoundaryCurves& curves, float minAngle, CurveFit goal,
			   ResultMesh& result, Workers& workers)
{
	CurveFitter(surface, curves, minAngle, goal, result, workers).run();
}

} // namespace gpr
