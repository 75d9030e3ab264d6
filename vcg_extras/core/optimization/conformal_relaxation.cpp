// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "conformal_relaxation.h"

#include "curve_slide.h"
#include "move_guard.h"
#include "relaxation.h"

#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

constexpr int stepsBetweenFlips = 3;
/// The momentum fades over the last steps, which then damp what it left of short waves.
constexpr int calmSteps = 2;

/// 1 / (2√3): E = k·(sum of squared edges) / (2·area).
constexpr float k = 0.28867513f;
/// Rings with a face above this energy move by guarded steps.
constexpr float poorEnergy = 1.35f;
/// Twice a face's area counts as at least this, in squared local edges.
constexpr float leastCross = 0.02f;

// Longest moves, in local edges.
constexpr float longestDescent = 0.15f, longestMove = 0.3f, longestSlide = 0.1f;

/// Vertices that slide keep this distance from their neighbours on the curve, in local edges.
constexpr float leastSpacing = 0.6f;
/// A slide may lower the worst angle of the ring down to this.
constexpr float leastSlideAngle = 34 * radians;

/// What the faces round a vertex want.
struct Pull {
	Vec3f descent; ///< tangential; the Newton step without its rate
	float worstEnergy = 0;
	float edge        = 0; ///< local edge length: root mean square of the ring's
};

float meanSquaredEdge(const HalfEdgeMesh& m, int v)
{
	float sum = 0;
	int   n   = 0;
	forEachNeighbour(m, v, [&](int w) {
		sum += squaredLength(m.position[w] - m.position[v]);
		++n;
	});
	return n > 0 ? sum / float(n) : 0.0f;
}

/// Sums what the faces at a vertex want: the gradient of E over p for the face (p, p + a, p + b) of
/// normal n,
///     -2k(a + b) / 2A - E / 2A · n × (b - a),
/// and the diagonal of its Hessian, 4k / 2A.
class PullSum {
public:
	explicit PullSum(float squaredEdge) : leastArea_(leastCross * squaredEdge)
	{
		pull_.edge = std::sqrt(squaredEdge);
	}

	void add(const Vec3f& a, const Vec3f& b, const Vec3f& normal, float twiceArea)
	{
		const Vec3f across  = b - a;
		const float inverse = 1 / std::max(twiceArea, leastArea_);
		const float edges   = squaredLength(a) + squaredLength(b) + squaredLength(across);
		const float energy  = k * edges * inverse;
		gradient_ += (a + b) * (-2 * k * inverse);
		gradient_ += cross(normal, across) * (-energy * inverse);
		hessian_ += 4 * k * inverse;
		pull_.worstEnergy = std::max(pull_.worstEnergy, energy);
	}

	Pull result()
	{
		if (hessian_ > 0) pull_.descent = gradient_ * (-1 / hessian_);
		return pull_;
	}

private:
	float leastArea_;
	Pull  pull_;
	Vec3f gradient_;
	float hessian_ = 0;
};

/// What the ring of v wants. add(sum, a, b, n) adds the face v, v + a, v + b; n = a × b.
template <class Add>
Pull sumRing(const HalfEdgeMesh& m, int v, const Add& add)
{
	const float squared = meanSquaredEdge(m, v);
	if (!(squared > 0)) return {};
	PullSum sum(squared);
	forEachFaceRound(m, v,
					 [&](int, const Vec3f& a, const Vec3f& b) { add(sum, a, b, cross(a, b)); });
	return sum.result();
}

/// At a vertex of flat ground. A face that looks the wrong way counts as one without area.
Pull pullOn(const HalfEdgeMesh& m, int v, const Vec3f& normal)
{
	Pull pull    = sumRing(m, v, [&](PullSum& sum, const Vec3f& a, const Vec3f& b, const Vec3f& n) {
        sum.add(a, b, normal, dot(n, normal) > 0 ? length(n) : 0);
    });
	pull.descent = tangential(pull.descent, normal);
	return pull;
}

/// At a vertex of a curve, where faces may look anywhere; not tangential.
Pull pullAcross(const HalfEdgeMesh& m, int v)
{
	return sumRing(m, v, [](PullSum& sum, const Vec3f& a, const Vec3f& b, const Vec3f& n) {
		const float l = length(n);
		if (l > 0) sum.add(a, b, n * (1 / l), l);
	});
}

Vec3f shortened(const Vec3f& a, float longest)
{
	const float l = length(a);
	return l > longest ? a * (longest / l) : a;
}

class ConformalRelaxer {
public:
	ConformalRelaxer(const Surface& surface, const BoundaryCurves& curves,
					 const ConformalSteps& steps, ResultMesh& result, Workers& workers) :
			surface_(surface),
			curves_(curves), steps_(steps), r_(result), m_(result.mesh), workers_(workers),
			guard_(result, workers), momentum_(result.vertex.size(), Vec3f())
	{
	}

	void run()
	{
		for (int step = 0; step < steps_.stepNum; ++step) {
			if (step % stepsBetweenFlips == 0) flat_ = findFlatVertices(r_, workers_);
			const int left = steps_.stepNum - 1 - step;
			share_ =
				left >= calmSteps ? steps_.momentum : steps_.momentum * float(left) / calmSteps;
			moveAll();
			const bool isLast = step + 1 == steps_.stepNum;
			if (isLast || step % stepsBetweenFlips == stepsBetweenFlips - 1)
				flipToDelaunay(r_, workers_, steps_.flipPasses);
		}
	}

private:
	const Surface&        surface_;
	const BoundaryCurves& curves_;
	const ConformalSteps& steps_;
	ResultMesh&           r_;
	const HalfEdgeMesh&   m_;
	Workers&              workers_;
	MoveGuard             guard_;
	Buffer<Vec3f>         momentum_; ///< the last move of each vertex
	Buffer<char>          flat_;
	float                 share_ = 0; ///< of the last move that is made again in this step

	void moveAll()
	{
		guard_.clear();
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (int v = int(begin); v < int(end); ++v)
				proposeMove(v);
		});
		guard_.move();
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v) {
				if (!guard_.moved(int(v))) momentum_[v] = Vec3f();
			}
		});
	}

	void proposeMove(int v)
	{
		const ResultVertex& r       = r_.vertex[v];
		const bool          onCurve = m_.isCurveVertex(v);
		if (r.isCorner || (onCurve ? r.curve < 0 : !flat_[v])) return;
		const Pull  pull    = onCurve ? pullAcross(m_, v) : pullOn(m_, v, r.normal);
		const Vec3f descent = shortened(pull.descent * steps_.rate, longestDescent * pull.edge);
		if (onCurve)
			proposeSlide(v, descent, pull.edge);
		else
			proposeWalk(v, descent, pull);
	}

	void proposeWalk(int v, const Vec3f& descent, const Pull& pull)
	{
		const bool   isPoor = pull.worstEnergy > poorEnergy;
		ResultVertex next   = r_.vertex[v];
		Vec3f        move   = descent;
		if (!isPoor) move += tangential(momentum_[v], next.normal) * share_;
		move         = shortened(move, longestMove * pull.edge);
		momentum_[v] = move;
		if (!(squaredLength(move) > 0)) return;
		const WalkEnd end = walk(surface_.mesh, next.anchor, move);
		if (isPoor && (end != WalkEnd::Arrived || lowersWorstAngle(v, next.anchor.position)))
			return;
		next.normal = surface_.mesh.faceNormal(next.anchor.face);
		guard_.propose(v, next);
	}

	bool lowersWorstAngle(int v, const Vec3f& p) const
	{
		return smallestAngleAround(m_, v, p, 0) < smallestAngleAround(m_, v, m_.position[v], 0);
	}

	void proposeSlide(int v, const Vec3f& descent, float edge)
	{
		const ResultVertex& r    = r_.vertex[v];
		const SlideRoom     room = slideRoom(r_, curves_, v);
		if (!room.isOpen()) return;
		const float longest = longestSlide * edge;
		const float wanted  = dot(descent, slideDirection(curves_, r, room));
		const float arc     = std::clamp(wanted, -longest, longest);
		const float ahead   = arc > 0 ? room.forward : room.backward;
		if (arc == 0 || ahead - std::abs(arc) < leastSpacing * edge) return;
		if (!slideKeepsToCurve(r_, curves_, v, room, arc)) return;
		if (!slideKeepsSpacing(r_, curves_, v, room, arc)) return;
		const ResultVertex next  = slid(surface_, curves_, r, arc);
		const float        worst = smallestAngleAround(m_, v, next.anchor.position, 0);
		if (worst < 0) return;
		const float before = smallestAngleAround(m_, v, r.anchor.position, 0);
		if (worst < leastSlideAngle && worst < before) return;
		guard_.propose(v, next);
	}
};

} // namespace

ConformalSteps conformalSteps(int stepNum)
{
	if (stepNum <= 7) return {stepNum, 0.7f, 1, untilDelaunay};
	if (stepNum <= 15) return {stepNum, 0.8f, 0.7f, untilDelaunay};
	if (stepNum <= 25) return {stepNum, 0.85f, 0.7f, untilDelaunay};
	return {stepNum, 0.9f, 0.7f, untilDelaunay};
}

void relaxConformally(const Surface& surface, const BoundaryCurves& curves,
					  const ConformalSteps& steps, ResultMesh& result, Workers& workers)
{
	ConformalRelaxer(surface, curves, steps, result, workers).run();
}

} // namespace gpr
