// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "relaxation.h"

#include "descent.h"
#include "terms.h"

#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/features/curve_slide.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/sectors.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Weight of area per vertex; empty for triangles of equal size. Lloyd's theory needs a density of
/// 1/size to the fourth power. For barycentres of rings, whose faces already have graded sizes, the
/// third power keeps the grading.
Buffer<float> findDensities(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	Buffer<float> density = sizesOf(surface, result, workers);
	for (float& d : density)
		d = 1 / (d * d * d);
	return density;
}

/// A step over the surface: every flat vertex moves by the tangential part of way(v).
template <class Way>
void walkOnce(const Surface& surface, const Way& way, ResultMesh& result, Workers& workers)
{
	SurfaceDescent descent(acceptanceOf(Driver::Relaxation), result, workers);
	descent.step([&](int v) -> std::optional<ResultVertex> {
		if (!mayWalk(constraintOf(result, v)) || !isFlat(result.mesh, v)) return {};
		ResultVertex next = result.vertex[v];
		const Vec3f  step = tangential(way(v), next.normal);
		if (!(squaredLength(step) > 0)) return {};
		walkBy(surface, step, next);
		return next;
	});
}

// ---- creases

/// Share of the way to the next vertex on the line: two neighbours that slide towards each other
/// keep a distance.
constexpr float longestCreaseSlide = 0.3f;

void slideOnCrease(const Surface& surface, const BoundaryCurves& curves, int v, ResultMesh& r)
{
	const SlideRoom room = slideRoom(r, curves, v);
	if (!room.isOpen()) return;
	const float wanted = dot(wayToBarycentre(r.mesh, v), slideDirection(curves, r.vertex[v], room));
	const float step =
		std::clamp(wanted, -longestCreaseSlide * room.backward, longestCreaseSlide * room.forward);
	const ResultVertex to = slid(surface, curves, r.vertex[v], step);
	if (spoilsRing(acceptanceOf(Driver::Relaxation), r.mesh, v, to.point.position)) return;
	if (!slideKeepsToCurve(r, curves, v, room, step)) return;
	r.vertex[v]        = to;
	r.mesh.position[v] = to.point.position;
}

// ---- conformal

/// Flips after every step give the same regularity and a 5 % larger mean distance; flips after
/// every sixth step give less regularity (means of six models).
constexpr int stepsBetweenFlips = 3;
/// The momentum fades over the last steps, which then damp short waves.
constexpr int calmSteps = 2;

/// Above this energy of a face, the vertices of the ring move by guarded steps.
constexpr float poorEnergy = 1.35f;
/// Lower limit of twice the area of a face, in squared local edges.
constexpr float minCross = 0.02f;

// Longest moves, in local edges.
constexpr float longestDescent = 0.15f, longestMove = 0.3f, longestSlide = 0.1f;

/// Sliding vertices keep this distance from neighbours on the curve, in local edges.
constexpr float minSpacing = 0.6f;
/// A slide may lower the worst angle of the ring to this angle.
constexpr float minSlideAngle = 34 * radians;

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

/// The pull of the ring of a vertex.
struct RingPull {
	Vec3f newton; ///< step to the place without force; not tangential on curves
	float worstEnergy = 0;
	float edge        = 0; ///< local edge length: root mean square over the ring
};

/// normal: of the surface at v. A face with the opposite normal counts as degenerate; faces at a
/// curve may have any normal.
RingPull pullOf(const HalfEdgeMesh& m, int v, bool onCurve, const Vec3f& normal)
{
	const float squared = meanSquaredEdge(m, v);
	if (!(squared > 0)) return {};
	RingPull      ring;
	ConformalPull sum;
	forEachFaceRound(m, v, [&](int, const Vec3f& a, const Vec3f& b) {
		const Vec3f n         = cross(a, b);
		const float twiceArea = onCurve || dot(n, normal) > 0 ? length(n) : 0.0f;
		if (onCurve && !(twiceArea > 0)) return;
		const float inverse = 1 / std::max(twiceArea, minCross * squared);
		const float energy  = onCurve ? sum.add(a, b, n * (1 / twiceArea), 1, inverse)
									  : sum.add(a, b, normal, 1, inverse);
		ring.worstEnergy    = std::max(ring.worstEnergy, energy);
	});
	if (sum.stiffness > 0) ring.newton = sum.force * (1 / sum.stiffness);
	if (!onCurve) ring.newton = tangential(ring.newton, normal);
	ring.edge = std::sqrt(squared);
	return ring;
}

class ConformalRelaxer {
public:
	ConformalRelaxer(const Surface& surface, const BoundaryCurves& curves,
					 const ConformalSteps& steps, ResultMesh& result, Workers& workers) :
			surface_(surface),
			curves_(curves), steps_(steps), r_(result), m_(result.mesh), workers_(workers),
			descent_(acceptanceOf(Driver::Relaxation), result, workers), last_(result.vertex.size())
	{
	}

	void run()
	{
		for (int step = 0; step < steps_.stepNum; ++step) {
			if (step % stepsBetweenFlips == 0) flat_ = findFlatVertices(m_, workers_);
			const int left = steps_.stepNum - 1 - step;
			share_ =
				left >= calmSteps ? steps_.momentum : steps_.momentum * float(left) / calmSteps;
			descent_.step([&](int v) { return next(v); });
			if (left == 0 || step % stepsBetweenFlips == stepsBetweenFlips - 1)
				flipToDelaunay(r_, workers_);
		}
	}

private:
	const Surface&        surface_;
	const BoundaryCurves& curves_;
	const ConformalSteps& steps_;
	ResultMesh&           r_;
	const HalfEdgeMesh&   m_;
	Workers&              workers_;
	SurfaceDescent        descent_;
	Buffer<Vec3f>         last_; ///< the last move of each vertex that walks
	Buffer<char>          flat_;
	float                 share_ = 0; ///< of the last move, repeated in this step

	std::optional<ResultVertex> next(int v)
	{
		const Constraint constraint = constraintOf(r_, v);
		const bool       onCurve    = constraint == Constraint::Curve;
		if (!onCurve && !(mayWalk(constraint) && flat_[v])) return {};
		const RingPull pull = pullOf(m_, v, onCurve, r_.vertex[v].normal);
		const Vec3f    step = shortened(pull.newton * steps_.rate, longestDescent * pull.edge);
		return onCurve ? slide(v, step, pull.edge) : walkOn(v, step, pull);
	}

	std::optional<ResultVertex> walkOn(int v, const Vec3f& step, const RingPull& pull)
	{
		const bool   isPoor = pull.worstEnergy > poorEnergy;
		const float  share  = isPoor ? 0 : share_;
		ResultVertex next   = r_.vertex[v];
		const Vec3f  last   = descent_.moved(v) ? tangential(last_[v], next.normal) : Vec3f();
		const Vec3f  move   = moveWithMomentum(last, share, step, longestMove * pull.edge);
		last_[v]            = move;
		if (!(squaredLength(move) > 0)) return {};
		const bool arrives = walkBy(surface_, move, next) == WalkEnd::Arrived;
		if (isPoor && (!arrives || lowersWorstAngle(v, next.point.position))) return {};
		return next;
	}

	bool lowersWorstAngle(int v, const Vec3f& p) const
	{
		return smallestAngleAround(m_, v, p, 0) < smallestAngleAround(m_, v, m_.position[v], 0);
	}

	std::optional<ResultVertex> slide(int v, const Vec3f& step, float edge) const
	{
		const ResultVertex& here = r_.vertex[v];
		const SlideRoom     room = slideRoom(r_, curves_, v);
		if (!room.isOpen()) return {};
		const float longest = longestSlide * edge;
		const float wanted  = dot(step, slideDirection(curves_, here, room));
		const float arc     = std::clamp(wanted, -longest, longest);
		const float ahead   = arc > 0 ? room.forward : room.backward;
		if (arc == 0 || ahead - std::abs(arc) < minSpacing * edge) return {};
		if (!slideKeepsToCurve(r_, curves_, v, room, arc)) return {};
		if (!slideKeepsSpacing(r_, curves_, v, room, arc)) return {};
		const ResultVertex next  = slid(surface_, curves_, here, arc);
		const float        worst = smallestAngleAround(m_, v, next.point.position, 0);
		const float        least =
			std::min(minSlideAngle, smallestAngleAround(m_, v, here.point.position, 0));
		if (worst < 0 || worst < least) return {};
		return next;
	}
};

} // namespace

void relaxOnce(const Surface& surface, ResultMesh& result, Workers& workers)
{
	const Buffer<float> density = findDensities(surface, result, workers);
	const auto          way     = [&](int v) { return wayToBarycentre(result.mesh, v, density); };
	walkOnce(surface, way, result, workers);
}

void smoothByUmbrella2(const Surface& surface, ResultMesh& result, Workers& workers)
{
	const Buffer<Vec3f> umbrella = secondOrderUmbrella(result.mesh, workers);
	const auto          way      = [&](int v) { return umbrella[v] * -1.0f; };
	walkOnce(surface, way, result, workers);
}

void slideAlongCreases(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result)
{
	if (!result.mesh.hasCreases()) return;
	for (int v = 0; v < result.mesh.vertexNum; ++v) {
		if (result.vertex[v].curve >= 0 && !result.mesh.isBorderVertex(v))
			slideOnCrease(surface, curves, v, result);
	}
}

ConformalSteps conformalSteps(int stepNum)
{
	if (stepNum <= 7) return {stepNum, 0.7f, 1};
	if (stepNum <= 15) return {stepNum, 0.8f, 0.7f};
	if (stepNum <= 25) return {stepNum, 0.85f, 0.7f};
	return {stepNum, 0.9f, 0.7f};
}

void relaxConformally(const Surface& surface, const BoundaryCurves& curves,
					  const ConformalSteps& steps, ResultMesh& result, Workers& workers)
{
	ConformalRelaxer(surface, curves, steps, result, workers).run();
}

} // namespace gpr
