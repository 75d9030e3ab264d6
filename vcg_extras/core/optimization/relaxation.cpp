// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "relaxation.h"

#include "rings.h"
#include "terms.h"

#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/edit/move_guard.h>
#include <vcg_extras/core/features/curve_slide.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/sectors.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <cmath>
#include <optional>

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

/// Steps on the surface and its curves that move all vertices at once (Jacobi): the position of a
/// vertex is the place of its record.
class SurfaceDescent {
public:
	SurfaceDescent(ResultMesh& result, Workers& workers) :
			guard_(acceptanceOf(Driver::Relaxation), Shortening(), result.mesh, workers),
			r_(result), m_(result.mesh), workers_(workers), next_(result.vertex.size()),
			moves_(result.vertex.size(), 0)
	{
	}

	/// next(v) returns the new record of v, or none if v stays; all calls see the places before the
	/// step. A template, so that the terms in `next`, which take most of the time, are inlined into
	/// the loop.
	template <class Next>
	void step(const Next& next)
	{
		guard_.start();
		workers_.forEach(m_.vertexNum, [&](int v) {
			const std::optional<ResultVertex> to = next(v);
			moves_[v]                            = to.has_value();
			if (to) next_[v] = *to;
		});
		workers_.forEach(m_.vertexNum, [&](int v) {
			if (moves_[v]) m_.position[v] = next_[v].point.position;
		});
		guard_.takeOver();
		guard_.settle();
		workers_.forEach(m_.vertexNum, [&](int v) {
			moves_[v] = moves_[v] && m_.position[v] == next_[v].point.position;
			if (moves_[v]) r_.vertex[v] = next_[v];
		});
	}

	/// Whether v's move in the last step stood.
	bool moved(int v) const { return moves_[v] != 0; }

private:
	MoveGuard            guard_;
	ResultMesh&          r_;
	HalfEdgeMesh&        m_;
	Workers&             workers_;
	Buffer<ResultVertex> next_;
	Buffer<char>         moves_;
};

/// The record of a vertex after a walk by the tangential part of a way; none if that is zero.
std::optional<ResultVertex> walked(const Surface& surface, const ResultVertex& from,
								   const Vec3f& way)
{
	const Vec3f step = tangential(way, from.normal);
	if (!(squaredLength(step) > 0)) return {};
	ResultVertex to = from;
	walkBy(surface, step, to);
	return to;
}

/// A step over the surface: every flat vertex moves by the tangential part of way(v).
template <class Way>
void walkOnce(const Surface& surface, const Way& way, ResultMesh& result, Workers& workers)
{
	SurfaceDescent descent(result, workers);
	descent.step([&](int v) -> std::optional<ResultVertex> {
		if (!mayWalk(constraintOf(result, v)) || !isFlat(result.mesh, v)) return {};
		return walked(surface, result.vertex[v], way(v));
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
/// Share of the last move to repeat (heavy ball, Polyak 1964). The momentum fades over the last
/// steps, which then damp short waves.
constexpr float momentum  = 0.7f;
constexpr int   calmSteps = 2;

/// Above this energy of a face, the vertices of the ring move by guarded steps.
constexpr float poorEnergy = 1.35f;
/// See ConformalFace.
constexpr float leastArea = 0.02f;

// Longest moves: of a step in local edges, of a slide in mean distances on the curve.
constexpr float longestDescent = 0.15f, longestMove = 0.3f, longestSlide = 0.1f;

/// Sliding vertices keep this distance from neighbours on the curve, in mean distances.
constexpr float minSpacing = 0.6f;
/// A slide may lower the worst angle of the ring to this angle.
constexpr float minSlideAngle = 34 * radians;

/// The conformal terms of the faces round a vertex.
struct RingPull {
	Float4 sum;             ///< of the forces, and of the stiffness
	float  worstEnergy = 0; ///< of a face
	float  squaredEdge = 0; ///< mean

	explicit RingPull(const Rings::Ring<ConformalFace>& ring)
	{
		for (int i = 0; i < ring.size; ++i) {
			const ConformalFace& face   = ring.term(i);
			const int            corner = ring.corner(i);
			sum += face.force[corner];
			worstEnergy = std::max(worstEnergy, face.energy);
			squaredEdge += face.squaredEdge[corner];
		}
		squaredEdge /= float(ring.size);
	}

	/// The Newton step to the place without force.
	Vec3f newton() const { return sum.xyz() * (1 / sum[3]); }
};

class ConformalRelaxer {
public:
	ConformalRelaxer(const Surface& surface, const BoundaryCurves& curves, int stepNum,
					 ResultMesh& result, Workers& workers) :
			surface_(surface),
			curves_(curves), stepNum_(stepNum), r_(result), m_(result.mesh), workers_(workers),
			descent_(result, workers), role_(result.vertex.size()), place_(result.vertex.size()),
			next_(result.vertex.size()), last_(result.vertex.size())
	{
		workers.forEach(last_.size(), [&](int v) { last_[v] = Vec3f(); });
	}

	void run()
	{
		for (int step = 0; step < stepNum_; step += stepsBetweenFlips) {
			stepInSpace(step, std::min(step + stepsBetweenFlips, stepNum_));
			descent_.step([&](int v) { return recordAfterSteps(v); });
			workers_.forEach(last_.size(), [&](int v) {
				if (!descent_.moved(v)) last_[v] = Vec3f();
			});
			flipToDelaunay(r_, workers_);
		}
	}

private:
	enum class Role : char { Stays, Walks, Slides };

	const Surface&        surface_;
	const BoundaryCurves& curves_;
	int                   stepNum_;
	ResultMesh&           r_;
	HalfEdgeMesh&         m_;
	Workers&              workers_;
	SurfaceDescent        descent_;
	Buffer<Role>          role_;
	Buffer<Vec3f>         place_; ///< of each vertex after the steps in space
	Buffer<Vec3f>         next_;  ///< of each vertex after the present step
	Buffer<Vec3f>         last_; ///< last move of a walking vertex; wanted move of a sliding vertex
	float                 share_ = 0; ///< of the last move, repeated in this step

	Role roleOf(int v, const Buffer<char>& flat) const
	{
		const Constraint constraint = constraintOf(r_, v);
		if (m_.outgoing[v] < 0) return Role::Stays;
		if (constraint == Constraint::Curve) return Role::Slides;
		return mayWalk(constraint) && flat[v] ? Role::Walks : Role::Stays;
	}

	/// Makes the steps from `begin` to `end` through space; place_ gets the places, and the mesh
	/// stays. One walk follows for all steps, since a walk costs more than a step. In a few steps,
	/// vertices of flat rings leave the surface by a distance of second order only.
	void stepInSpace(int begin, int end)
	{
		const Buffer<char> flat = findFlatVertices(m_, workers_);
		workers_.forEach(role_.size(), [&](int v) { role_[v] = roleOf(v, flat); });
		const Rings rings(m_, workers_);
		place_ = copyOf(m_.position, workers_);
		for (int step = begin; step < end; ++step) {
			const int left = stepNum_ - 1 - step;
			share_         = left >= calmSteps ? momentum : momentum * float(left) / calmSteps;
			rings.forEach<ConformalFace>(
				workers_, [&](int f) { return shapeOf(f); },
				[&](int v, const Rings::Ring<ConformalFace>& ring) {
					next_[v] = placeAfterStep(v, ring);
				});
			m_.position.swap(next_);
		}
		m_.position.swap(place_);
	}

	ConformalFace shapeOf(int f) const
	{
		const int* c  = &m_.origin[3 * f];
		const auto at = [&](int k) { return Float4(m_.position[c[k]]); };
		return {at(0), at(1), at(2), leastArea};
	}

	Vec3f placeAfterStep(int v, const Rings::Ring<ConformalFace>& ring)
	{
		const Vec3f here = m_.position[v];
		if (role_[v] == Role::Stays) return here;
		const RingPull pull(ring);
		const float    edge = std::sqrt(pull.squaredEdge);
		if (role_[v] == Role::Slides) {
			last_[v] = shortened(pull.newton(), longestDescent * edge);
			return here;
		}
		const Vec3f& normal = r_.vertex[v].normal;
		const bool   isPoor = pull.worstEnergy > poorEnergy;
		const Vec3f  step   = shortened(tangential(pull.newton(), normal), longestDescent * edge);
		const Vec3f  move = shortened(last_[v] * (isPoor ? 0 : share_) + step, longestMove * edge);
		if (isPoor && lowersWorstAngle(v, here + move)) {
			last_[v] = Vec3f();
			return here;
		}
		last_[v] = move;
		return here + move;
	}

	std::optional<ResultVertex> recordAfterSteps(int v) const
	{
		if (role_[v] == Role::Stays) return {};
		if (role_[v] == Role::Slides) return slide(v, last_[v]);
		return walked(surface_, r_.vertex[v], place_[v] - m_.position[v]);
	}

	bool lowersWorstAngle(int v, const Vec3f& p) const
	{
		return smallestAngleAround(m_, v, p) < smallestAngleAround(m_, v, m_.position[v]);
	}

	std::optional<ResultVertex> slide(int v, const Vec3f& step) const
	{
		const ResultVertex& here = r_.vertex[v];
		const SlideRoom     room = slideRoom(r_, curves_, v);
		if (!room.isOpen()) return {};
		const float edge    = (room.forward + room.backward) / 2;
		const float longest = longestSlide * edge;
		const float wanted  = dot(step, slideDirection(curves_, here, room));
		const float arc     = std::clamp(wanted, -longest, longest);
		const float ahead   = arc > 0 ? room.forward : room.backward;
		if (arc == 0 || ahead - std::abs(arc) < minSpacing * edge) return {};
		if (!slideKeepsToCurve(r_, curves_, v, room, arc)) return {};
		if (!slideKeepsSpacing(r_, curves_, v, room, arc)) return {};
		const ResultVertex next  = slid(surface_, curves_, here, arc);
		const float        worst = smallestAngleAround(m_, v, next.point.position);
		const float        least =
			std::min(minSlideAngle, smallestAngleAround(m_, v, here.point.position));
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

void relaxConformally(const Surface& surface, const BoundaryCurves& curves, int stepNum,
					  ResultMesh& result, Workers& workers)
{
	ConformalRelaxer(surface, curves, stepNum, result, workers).run();
}

} // namespace gpr
