// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit.h"

#include "curve_fit.h"
#include "descent.h"
#include "rings.h"
#include "terms.h"
#include "worst_distances.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/surface/closest_face_map.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gpr {

namespace {

/// Jacobi steps of a round. More make triangles a little more regular and the distance a little
/// larger, as less of a weight of the shape does.
constexpr int stepNum = 4;
/// Length of a step over that of Newton's for the vertex alone, and share of the last one kept.
constexpr float stepLength = 0.85f;
constexpr float momentum   = 0.7f;
/// μ: pull to where the round began.
constexpr float pullBack = 0.02f;
/// A step is at most this share of the vertex' shortest edge.
constexpr float longestStep = 0.15f;
/// A round moves a vertex at most this share of the mean edge round it.
constexpr float farthestMove = 0.3f;
/// Squared edge of an equilateral triangle over its area.
constexpr float squaredEdgePerArea = 2.3094011f;

/// Passes over the whole result at the end; each puts vertices back for good.
constexpr int maxTakeBacks = 32;

/// A thirtieth of a move is not worth more halvings. The rounds are only a bound: reaching it is
/// told (FitOutcome::capped).
constexpr Shortening shorteningOfFit = {5, 64};

Acceptance limitsOfFit(const FitSettings& settings)
{
	Acceptance limits = acceptanceOf(Driver::Fit, settings.minAngleDeg * radians);
	limits.falls      = 0.9999f; // rounding is no fall
	return limits;
}

/// Rounds of the descent: what a vertex wants by the distance, its shape and the pull back.
class FitRounds {
public:
	FitRounds(const Surface& surface, const FitSettings& settings, const Buffer<char>& isFree,
			  ResultMesh& result, Workers& workers) :
			surface_(surface),
			settings_(settings), isFree_(isFree), r_(result), m_(result.mesh), workers_(workers),
			rings_(m_, workers), distance_(m_, rings_),
			guard_(limitsOfFit(settings), shorteningOfFit, result.mesh, workers),
			shift_(m_.vertexNum), next_(m_.vertexNum), last_(m_.vertexNum), mass_(m_.vertexNum),
			squaredEdge_(m_.vertexNum)
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
					next_[v] = isFree_[v] ? shiftAfterStep(v, ring) : Vec3f();
				});
			shift_.swap(next_);
		}
		workers_.forEach(m_.vertexNum, [&](int v) { m_.position[v] += shift_[v]; });
		guard_.takeOver();
		return guard_.settle(smoothNormals(surface_, r_, workers_));
	}

private:
	const Surface&      surface_;
	const FitSettings&  settings_;
	const Buffer<char>& isFree_;
	ResultMesh&         r_;
	HalfEdgeMesh&       m_; ///< where the round began, until its end
	Workers&            workers_;
	Rings               rings_;
	DistanceTerm        distance_;
	MoveGuard           guard_;
	Buffer<Vec3f>       shift_;       ///< before the step
	Buffer<Vec3f>       next_;        ///< and behind it
	Buffer<Vec3f>       last_;        ///< moves of the step before
	Buffer<float>       mass_;        ///< Σ A_p b² of a vertex if the input were infinitely dense
	Buffer<float>       squaredEdge_; ///< of an equilateral triangle as large as the ones round it

	void begin(int v)
	{
		float area    = 0;
		int   faceNum = 0;
		forEachOutgoing(m_, v, [&](int h) {
			area += length(m_.faceCross(h / 3)) / 2;
			++faceNum;
		});
		shift_[v]       = Vec3f();
		last_[v]        = Vec3f();
		mass_[v]        = area / 6;
		squaredEdge_[v] = squaredEdgePerArea * area / float(faceNum);
	}

	/// Squared length × area, as the distance has it: the balance of the two does not depend on
	/// size.
	float shapeWeight(int v) const
	{
		const float edge = squaredEdge_[v];
		return settings_.shapeWeight * edge * edge / squaredEdgePerArea;
	}

	ConformalFace shapeOf(int f) const
	{
		const int* c  = &m_.origin[3 * f];
		const auto at = [&](int k) { return m_.position[c[k]] + shift_[c[k]]; };
		return {at(0), at(1), at(2)};
	}

	/// What the faces of a vertex say about its shape.
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

	/// The shift of v behind a step. Both terms of the energy are summed up in one turn round v:
	/// reading the ring is what a step costs.
	Vec3f shiftAfterStep(int v, const Rings::Ring<ConformalFace>& ring)
	{
		const float pull  = pullBack * mass_[v];
		Vec3f       force = distance_.force(v) - distance_.own(v) * shift_[v] - shift_[v] * pull;
		RingShape   shape;
		const int   first = rings_.begin(v);
		for (int i = 0; i < ring.size; ++i) {
			shape.add(ring.term(i), ring.corner(i));
			force = force - distance_.joint(first + i) * shift_[ring.spoke[i].target];
		}
		return shiftAgainst(v, shape, force, pull);
	}

	/// For the forces found; only the tangential part of the shape's counts.
	Vec3f shiftAgainst(int v, const RingShape& ring, Vec3f force, float pull)
	{
		const Vec3f normal = normalized(Vec3f(ring.normal[0], ring.normal[1], ring.normal[2]));
		const float weight = shapeWeight(v);
		const float stiff  = ring.force[3] * weight;
		force += tangential({ring.force[0], ring.force[1], ring.force[2]}, normal) * weight;

		SymmetricMatrix matrix = distance_.own(v);
		matrix.addDiagonal(pull + stiff);
		matrix.addOuter(normal, -stiff);
		last_[v] =
			moveWithMomentum(last_[v], momentum, matrix.solve(force).value_or(Vec3f()) * stepLength,
							 longestStep * std::sqrt(ring.shortest));
		return shortened(shift_[v] + last_[v], farthestMove * std::sqrt(squaredEdge_[v]));
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
		outcome.contacts = std::move(contacts_);
		outcome.farthest = farthestFromSurface(r_);
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
	KnownContacts         contacts_;

	/// False if a round, or all together, had to be taken back.
	bool fitSoundly(std::unique_ptr<ClosestFaceMap>& map)
	{
		MoveGuard whole(limits_, shorteningOfFit, m_, workers_);
		whole.start();
		fitCurves(surface_, curves_, limits_.angle, settings_.curveFit, r_);
		const bool allKept = fitInRounds(map);
		whole.takeOver();
		return takeBackOffenders(whole) && allKept;
	}

	/// False if a round had to take all its moves back.
	bool fitInRounds(std::unique_ptr<ClosestFaceMap>& map)
	{
		if (settings_.rounds == 0) return true;
		FitRounds rounds(surface_, settings_, isFree_, r_, workers_);
		map.reset(new ClosestFaceMap(surface_, r_, workers_));
		bool allKept = true;
		for (int round = 0; round < settings_.rounds; ++round) {
			if (round > 0) map->update(r_, workers_);
			allKept = rounds.run(*map, round + 1 == settings_.rounds) && allKept;
			followOnSurface();
		}
		// Before the search for intersecting faces needs memory.
		map->keepListsOnly();
		return allKept;
	}

	/// False if what intersects others then could not be told from what does not.
	bool lowerWorst(FitOutcome& outcome)
	{
		MoveGuard moves(limits_, shorteningOfFit, m_, workers_);
		moves.start();
		outcome.largestGap = lowerWorstDistances(surface_, *outcome.map, limits_.angle,
												 settings_.worstRounds, r_, workers_);
		moves.takeOver();
		// Records of vertices that stayed must stay: at a sharp edge they might walk round it.
		bool hasMoved = false;
		for (int v = 0; v < m_.vertexNum; ++v) {
			isFree_[v] = isFree_[v] && !(moves.shift(v) == Vec3f());
			hasMoved   = hasMoved || isFree_[v];
		}
		if (!hasMoved) return true;
		followOnSurface();
		return takeBackOffenders(moves);
	}

	/// Takes the moves of faces back that touch others or are inverted where the records are now.
	/// False if there was no end to it and all moves were taken back.
	bool takeBackOffenders(MoveGuard& moves)
	{
		for (int i = 0; i < maxTakeBacks; ++i) {
			const Buffer<Vec3f>    normal   = smoothNormals(surface_, r_, workers_);
			const std::vector<int> touching = facesThatTouch();
			const auto looksAgainst = [&](int f) { return normalAgreement(m_, normal, f) < 0; };
			std::vector<int> faces  = workers_.collectIf(m_.faceNum, looksAgainst);
			faces.insert(faces.end(), touching.begin(), touching.end());
			const auto stands = [&](int f) { return !moves.hasMoved(f); };
			faces.erase(std::remove_if(faces.begin(), faces.end(), stands), faces.end());
			if (faces.empty()) return true;
			moves.takeBack(faces, normal);
			followOnSurface();
		}
		moves.takeAllBack();
		followOnSurface();
		return false;
	}

	std::vector<int> facesThatTouch()
	{
		std::vector<int> faces;
		for (const FacePair& pair : contacts_.find(m_, workers_))
			faces.insert(faces.end(), {pair.first, pair.second});
		sortUnique(faces);
		return faces;
	}

	/// Records go where the vertices went, on the surface.
	void followOnSurface()
	{
		workers_.forEach(m_.vertexNum, [&](int v) {
			if (!isFree_[v]) return;
			ResultVertex& record = r_.vertex[v];
			const Vec3f   step   = m_.position[v] - record.point.position;
			walkBy(surface_, tangential(step, record.normal), record);
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
