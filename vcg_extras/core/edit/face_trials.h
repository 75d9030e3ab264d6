// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_FACE_TRIALS_H
#define VCG_EXTRAS_CORE_EDIT_FACE_TRIALS_H

#include "claims.h"
#include "goal.h"
#include "patch_distance.h"

#include <vcg_extras/core/mesh/face_boxes.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gpr {

/// What trials may use and change. Trials of several faces may run at the same time if these have
/// different claims.
struct TrialRoom {
	PatchEditor&  editor;
	Workers&      workers;                ///< polled by trials that run alone: pairs, contacts
	Assignment*   assignment;             ///< null: no limit on distances
	FacesInSpace* space;                  ///< null: contacts are not looked for
	const Claims* claims;                 ///< null if no search takes several faces
	int           claim = 0;              ///< the own claim
	std::int64_t  work = 0, attempts = 0; ///< left
};

/// The trials at one bad face: operations are tried, and the mesh round each of these settles by
/// moves and flips. The trial with the largest fall of cost within the limits is kept; all other
/// trials are undone.
class FaceTrials {
public:
	/// A kept change.
	struct Kept {
		std::vector<Operation> operations;
		std::vector<int>       patch; ///< vertices that moved, are new, or have other faces
	};

	FaceTrials(const TrialRoom& room, const Goal& goal) :
			room_(room), editor_(room.editor), m_(room.editor.mesh()), goal_(goal)
	{
	}

	/// Changes the mesh at f, which is bad, while a change helps.
	void improve(int f);

	const std::vector<Kept>& kept() const { return kept_; }
	bool                     hasFailed() const { return hasFailed_; } ///< nothing helped at last
	std::int64_t             workLeft() const { return room_.work; }
	std::int64_t             attemptsLeft() const { return room_.attempts; }

private:
	/// The worst figures of the faces of a patch; only limited figures are measured.
	struct Worst {
		float agreement   = 1;
		int   invertedNum = 0;
		float angle       = HUGE_VALF;
	};

	/// The figures that a step of a vertex must not make worse.
	struct StepLimits {
		Worst                          worst;
		std::unique_ptr<PatchDistance> distance;
	};

	/// A patch before a trial.
	struct Before {
		PatchEditor::Snapshot           snapshot;
		Triangles                       triangles;
		Worst                           worst;
		float                           cost     = 0;
		float                           meanEdge = 0;
		std::vector<std::array<int, 3>> seeds; ///< if gaps are limited: faces of the surface
		bool keepsFaces = false;               ///< the trial keeps the numbers of faces
		/// Measured on first use.
		std::unique_ptr<PatchDistance> distance;

		explicit Before(PatchEditor::Snapshot s) : snapshot(std::move(s)) {}
		const std::vector<int>& faces() const { return snapshot.backup.faces(); }
	};

	TrialRoom           room_;
	PatchEditor&        editor_;
	const HalfEdgeMesh& m_;
	const Goal&         goal_;
	std::vector<Kept>   kept_;
	bool                hasFailed_ = false;

	bool                   isExhausted() const;
	bool                   mayChange(const std::vector<int>& patch) const;
	bool                   takeEach(int f);
	bool                   takeBest(int f);
	std::vector<Operation> bestSingle(int f);
	std::vector<Operation> bestPair(int f);
	int                    costliest(const std::vector<int>& faces) const;
	void                   keep(const std::vector<Operation>& ops);
	std::vector<int>       patchOf(const std::vector<Operation>& ops);

	Before                         lookAt(const Operation& op, const std::vector<int>& patch);
	Before                         lookAt(PatchEditor::Snapshot snapshot);
	std::vector<int>               facesNow(const Before& before) const;
	float                          attempt(const Operation& op, Before before, float known);
	float                          gainOver(const Before& before);
	bool                           keepsLimits(Before& before);
	std::unique_ptr<PatchDistance> distanceOf(const std::vector<int>& faces,
											  const Triangles& triangles, float edge);
	bool keepsDistance(const PatchDistance* distance, const std::vector<int>& faces);
	bool limitsGaps() const { return goal_.limits.gap < HUGE_VALF; }
	bool keepsGap(const Before& before, const std::vector<int>& faces);
	/// Per face: the surface faces below its corners.
	std::vector<std::array<int, 3>> seedsOf(const std::vector<int>& faces) const;
	float squaredGapOf(const Triangles& triangles, const std::vector<std::array<int, 3>>& seeds,
					   float allowed);
	float costOf(const std::vector<int>& faces);
	Worst worstOf(const std::vector<int>& faces);
	bool  keepsWorst(const std::vector<int>& faces, const Worst& before);

	bool make(const Operation& op);
	void settle(const std::vector<int>& patch);
	bool flipIfBetter(int h, const std::vector<int>& patch);
	bool moveToBest(int v);
	bool stepFrom(int v, float reach, float& cost);

	/// The number of touching pairs with a face of `faces`, ascending.
	int              contactNum(const std::vector<int>& faces);
	std::vector<int> ringsRound(int f, int ringNum);
};

} // namespace gpr

#endif
