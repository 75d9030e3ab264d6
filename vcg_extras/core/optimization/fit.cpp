// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit.h"

#include "curve_fit.h"
#include "rings.h"
#include "terms.h"
#include "worst_distances.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/edit/move_guard.h>
#include <vcg_extras/core/surface/closest_face_map.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gpr {

namespace {

/// Jacobi steps of a round. More steps improve the regularity a little and enlarge the distance a
/// little.
constexpr int stepNum = 4;
/// Length of a step as a share of the Newton step of the vertex alone, and share of the last step
/// to keep (heavy ball, Polyak 1964).
constexpr float stepLength = 0.85f;
constexpr float momentum   = 0.7f;
/// μ: pull to the start of the round.
constexpr float pullBack = 0.02f;
/// A step is at most this share of the shortest edge at the vertex.
constexpr float longestStep = 0.15f;
/// A round moves a vertex by at most this share of the mean edge at the vertex.
constexpr float farthestMove = 0.3f;
/// Squared edge of an equilateral triangle over its area.
constexpr float squaredEdgePerArea = 2.3094011f;

/// Without rounds, a vertex rises by this share of the height over its ring. Triangles
/// with corners on a sphere lie h²/8R below the sphere in the mean, which is a quarter of the
/// height. A third is better where the surface has details finer than the triangles (seven models).
constexpr float raisedShare = 1.0f / 3;

/// Most passes over the whole result at the end; each pass puts vertices back for good.
constexpr int maxTakeBacks = 32;

/// 5 halvings, because a thirtieth of a move is not worth more; the 64 rounds are only a bound, and
/// reaching the bound is told (FitOutcome::capped).
constexpr Shortening shorteningOfFit = {5, 64};

Acceptance limitsOfFit(const FitSettings& settings)
{
	Acceptance limits = acceptanceOf(Driver::Fit, settings.minAngleDeg * radians);
	limits.falls      = 0.9999f; // a rounding error is no fall
	return limits;
}

/// Rounds of the descent by the distance, the shape of the triangles and the pull back.
class FitRounds {
public:
	FitRounds(const Surface& surface, const FitSettings& settings, const Buffer<char>& isFree,
			  ResultMesh& result, Workers& workers) :
			surface_(surface),
			settings_(settings), isFree_(isFree), r_(result), m_(result.mesh), workers_(workers),
			rings_(m_, workers), distance_(m_, rings_),
			guard_(limitsOfFit(settings), shorteningOfFit, result.mesh, workers),
			start_(m_.vertexNum), shift_(m_.vertexNum), next_(m_.vertexNum), last_(m_.vertexNum),
			mass_(m_.vertexNum), squaredEdge_(m_.vertexNum)
	{
	}

	/// isLast: no other round follows. False if all moves had to be taken back.
	bool run(const ClosestFaceMap& map, bool isLast)
	{
		distance_.assemble(surface_, map, !isLast, workers_);
		guard_.start();
		workers_.forEach(m_.vertexNum, [&](int v) { begin(v); });
		for (int step = 0; step < stepNum; ++step) {
			rings_.forEach<ConformalFace>(
				workers_, [&](int f) { return shapeOf(f); },
				[&](int v, const Rings::Ring<ConformalFace>& ring) {
					next_[v] = isFree_[v] ? Float4(shiftAfterStep(v, ring)) : Float4();
				});
			shift_.swap(next_);
		}
		workers_.forEach(m_.vertexNum, [&](int v) { m_.position[v] += shift_[v].xyz(); });
		guard_.takeOver();
		return guard_.settle(smoothNormals(surface_, r_, workers_));
	}

private:
	const Surface&      surface_;
	const FitSettings&  settings_;
	const Buffer<char>& isFree_;
	ResultMesh&         r_;
	HalfEdgeMesh&       m_; ///< start of the round, until the end of the round
	Workers&            workers_;
	Rings               rings_;
	DistanceTerm        distance_;
	MoveGuard           guard_;
	Buffer<Float4>      start_;       ///< places at the start of the round
	Buffer<Float4>      shift_;       ///< before the step
	Buffer<Float4>      next_;        ///< after the step
	Buffer<Vec3f>       last_;        ///< moves of the step before
	Buffer<float>       mass_;        ///< Σ A_p b² of a vertex if the input were infinitely dense
	Buffer<float>       squaredEdge_; ///< of an equilateral triangle with the mean area of the ring

	void begin(int v)
	{
		const float area    = distance_.force(v)[3] / 2;
		const int   faceNum = rings_.begin(v + 1) - rings_.begin(v);
		start_[v]           = Float4(m_.position[v]);
		shift_[v]           = Float4();
		last_[v]            = Vec3f();
		mass_[v]            = area / 6;
		squaredEdge_[v]     = squaredEdgePerArea * area / float(faceNum);
	}

	/// The weight of the shape in squared length × area, the unit of the distance term: the balance
	/// of both terms does not depend on size.
	float shapeWeight(int v) const
	{
		const float edge = squaredEdge_[v];
		return settings_.shapeWeight * edge * edge / squaredEdgePerArea;
	}

	ConformalFace shapeOf(int f) const
	{
		const int* c  = &m_.origin[3 * f];
		const auto at = [&](int k) { return start_[c[k]] + shift_[c[k]]; };
		return {at(0), at(1), at(2)};
	}

	/// The shape term of the ring of a vertex.
	struct RingShape {
		Float4 force;                ///< and the stiffness
		Float4 normal;               ///< area-weighted
		float  shortest = HUGE_VALF; ///< squared edge

		void add(const ConformalFace& face, int corner)
		{
			force += face.force[corner];
			normal += face.normal;
			shortest = std::min(shortest, face.squaredEdge[corner]);
		}
	};

	/// The shift of v after a step. Both terms are summed in a single pass round v, because reading
	/// the ring dominates the cost of a step.
	Vec3f shiftAfterStep(int v, const Rings::Ring<ConformalFace>& ring)
	{
		const float pull  = pullBack * mass_[v];
		Float4      force = distance_.force(v) - distance_.own(v) * shift_[v] - shift_[v] * pull;
		RingShape   shape;
		const int   first = rings_.begin(v);
		for (int i = 0; i < ring.size; ++i) {
			shape.add(ring.term(i), ring.corner(i));
			force = force - distance_.joint(first + i) * shift_[ring.spoke[i].target];
		}
		return shiftAgainst(v, shape, force.xyz(), pull);
	}

	/// The shift for the given forces; the shape contributes its tangential part only.
	Vec3f shiftAgainst(int v, const RingShape& ring, Vec3f force, float pull)
	{
		const Vec3f normal = normalized(ring.normal.xyz());
		const float weight = shapeWeight(v);
		const float stiff  = ring.force[3] * weight;
		force += tangential(ring.force.xyz(), normal) * weight;

		SymmetricMatrix matrix = distance_.own(v).matrix();
		matrix.addDiagonal(pull + stiff);
		matrix.addOuter(normal, -stiff);
		const Vec3f step = matrix.solve(force).value_or(Vec3f()) * stepLength;
		last_[v] = shortened(last_[v] * momentum + step, longestStep * std::sqrt(ring.shortest));
		return shortened(shift_[v].xyz() + last_[v], farthestMove * std::sqrt(squaredEdge_[v]));
	}
};

class Fitter {
public:
	Fitter(const Surface& surface, const BoundaryCurves& curves, const FitSettings& settings,
		   ResultMesh& result, Workers& workers) :
			surface_(surface),
			curves_(curves), settings_(settings), r_(result), m_(result.mesh), workers_(workers),
			limits_(limitsOfFit(settings)), isFree_(m_.vertexNum)
	{
		workers.forEach(m_.vertexNum,
						[&](int v) { isFree_[v] = constraintOf(r_, v) == Constraint::Free; });
	}

	FitOutcome run()
	{
		FitOutcome outcome;
		outcome.capped = !fitSoundly(outcome.map);
		if (settings_.worstRounds > 0 && outcome.map != nullptr && !lowerWorst(outcome))
			outcome.capped = true;
		return outcome;
	}

private:
	const Surface&        surface_;
	const BoundaryCurves& curves_;
	const FitSettings&    settings_;
	ResultMesh&           r_;
	HalfEdgeMesh&         m_;
	Workers&              workers_;
	Acceptance            limits_;
	Buffer<char>          isFree_; ///< vertices that may leave the surface

	/// False if the moves of a round, or of all rounds, were taken back.
	bool fitSoundly(std::unique_ptr<ClosestFaceMap>& map)
	{
		MoveGuard whole(limits_, shorteningOfFit, m_, workers_);
		whole.start();
		fitCurves(surface_, curves_, limits_.angle, settings_.curveFit, r_, workers_);
		if (settings_.rounds == 0) return raiseAll(whole) && takeBackOffenders(whole);
		const bool allKept = fitInRounds(map);
		whole.takeOver();
		return takeBackOffenders(whole) && allKept;
	}

	/// Raises all free vertices. False if the moves were taken back.
	bool raiseAll(MoveGuard& whole)
	{
		Buffer<Vec3f> raised(m_.vertexNum);
		workers_.forEach(m_.vertexNum, [&](int v) {
			raised[v] = m_.position[v];
			if (isFree_[v]) raised[v] += heightOverRing(m_, v) * raisedShare;
		});
		m_.position.swap(raised);
		whole.takeOver();
		const bool allKept = whole.settle();
		followOnSurface();
		return allKept;
	}

	/// False if a round had to take all its moves back.
	bool fitInRounds(std::unique_ptr<ClosestFaceMap>& map)
	{
		// First, as its search and the buffers of the rounds need much memory.
		map.reset(new ClosestFaceMap(surface_, r_, workers_));
		FitRounds rounds(surface_, settings_, isFree_, r_, workers_);
		bool      allKept = true;
		for (int round = 0; round < settings_.rounds; ++round) {
			if (round > 0) map->update(r_, workers_);
			allKept = rounds.run(*map, round + 1 == settings_.rounds) && allKept;
			followOnSurface();
		}
		return allKept;
	}

	/// Lowers the largest distances. False if all moves were taken back, because inverted
	/// faces were left.
	bool lowerWorst(FitOutcome& outcome)
	{
		MoveGuard moves(limits_, shorteningOfFit, m_, workers_);
		moves.start();
		outcome.largestGap = lowerWorstDistances(surface_, *outcome.map, limits_.angle,
												 settings_.worstRounds, r_, workers_);
		moves.takeOver();
		// Records of unmoved vertices must stay: at a crease edge a record might walk round the
		// edge.
		for (int v = 0; v < m_.vertexNum; ++v)
			isFree_[v] = isFree_[v] && !(moves.shift(v) == Vec3f());
		return takeBackOffenders(moves);
	}

	/// Takes back the moves of faces that are inverted at the present records. False if this did
	/// not end and all moves were taken back.
	bool takeBackOffenders(MoveGuard& moves)
	{
		for (int i = 0; i < maxTakeBacks; ++i) {
			const Buffer<Vec3f>    normal = smoothNormals(surface_, r_, workers_);
			const std::vector<int> faces  = workers_.collectIf(m_.faceNum, [&](int f) {
                return normalAgreement(m_, normal, f) < 0 && moves.hasMoved(f);
            });
			if (faces.empty()) return true;
			moves.takeBack(faces, normal);
			followOnSurface();
		}
		moves.takeAllBack();
		followOnSurface();
		return false;
	}

	/// Moves the records after the vertices, on the surface.
	void followOnSurface()
	{
		workers_.forEach(m_.vertexNum, [&](int v) {
			if (isFree_[v]) gpr::followOnSurface(surface_, v, r_);
		});
	}
};

} // namespace

FitOutcome fitToInput(const Surface& surface, const BoundaryCurves& curves,
					  const FitSettings& settings, ResultMesh& result, Workers& workers)
{
	return Fitter(surface, curves, settings, result, workers).run();
}

} // namespace gpr
