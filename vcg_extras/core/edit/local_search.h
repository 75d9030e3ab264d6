// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_LOCAL_SEARCH_H
#define VCG_EXTRAS_CORE_EDIT_LOCAL_SEARCH_H

#include "acceptance.h"
#include "failed_attempts.h"
#include "patch_distance.h"
#include "patch_editor.h"

#include <vcg_extras/core/mesh/face_boxes.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gpr {

/// The limits at which a search ends although bad faces are left.
struct Budget {
	int          rounds     = 8;    ///< passes over all bad faces
	float        maxLeft    = 1;    ///< another round needs at most this share of bad faces left
	std::int64_t attempts   = 2000; ///< faces to try
	bool         limitsWork = true; ///< whether the work of all searches is limited
};

/// The goal of a search.
struct Goal {
	std::function<bool(int face)>  isBad; ///< called in parallel
	std::function<float(int face)> faceCost;
	float maxLeft = 0.995f, minGain = 0; ///< a change leaves at most this share of cost, less this
	float collapseCost = 0; ///< a collapse must gain this much more than other operations
	float contactCost  = 0; ///< cost of a contact of a face; 0: contacts are not looked for
	std::vector<Operation::Kind> operations;
	std::vector<float>           stepLengths; ///< of moves, in mean edges
	bool       settles    = true;  ///< the mesh round a change settles by moves and flips
	bool       takesFirst = false; ///< every helpful operation is kept, not only the best
	bool       inPairs    = false; ///< two operations in a row
	bool       mayCrowd   = false; ///< vertices of curves may crowd
	Acceptance limits;
	Budget     budget;
};

/// Improves the worst faces of the result in turn. Every operation at a bad face is tried, and the
/// mesh round it settles by moves and flips. The trial with the largest fall of cost within the
/// limits is kept; all other trials are undone. A face without a helpful operation is left alone
/// until the mesh near the face changes. Serial, so that the outcome does not depend on threads.
class LocalSearch {
public:
	/// assignment: may be null if no goal limits distances. work: the work left for all runs, also
	/// of further searches, in faces, points and pairs of triangles; counts down. Reserves memory
	/// for spareVertexNum vertices.
	LocalSearch(const Surface& surface, const BoundaryCurves& curves, Assignment* assignment,
				std::int64_t& work, ResultMesh& result, Workers& workers, int spareVertexNum = 0);

	/// False if the budget ended the search and bad faces are left.
	bool             run(const Goal& goal);
	std::vector<int> findBad(const Goal& goal) const;
	/// Whether a face touches another face. During a search with a cost of contacts only.
	bool hasContact(int f) const;

	PatchEditor&        editor() { return editor_; }
	const HalfEdgeMesh& mesh() const { return m_; }
	int                 changeNum() const { return changeNum_; }

private:
	/// The worst figures of the faces of a patch; only limited figures are measured.
	struct Worst {
		float agreement   = 1;
		int   invertedNum = 0;
		float angle       = HUGE_VALF;
	};

	/// The figures that a step of a vertex must not make worse.
	struct StepLimits {
		bool                           isKnown = false;
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
		int  intersections = 0;                ///< pairs, if there are any near the patch
		bool keepsFaces    = false;            ///< the trial keeps the numbers of faces
		/// Measured on first use.
		std::unique_ptr<PatchDistance> distance;

		explicit Before(PatchEditor::Snapshot s) : snapshot(std::move(s)) {}
		const std::vector<int>& faces() const { return snapshot.backup.faces(); }
	};

	PatchEditor                editor_;
	const HalfEdgeMesh&        m_;
	Assignment*                assignment_;
	Workers&                   workers_;
	std::int64_t&              work_; ///< left
	const Goal*                goal_ = nullptr;
	FailedAttempts             failed_{0};
	std::vector<int>           touched_;                ///< vertices that changed in this round
	std::unique_ptr<FaceBoxes> boxes_;                  ///< made on first use
	std::vector<int>           changedFaces_;           ///< since boxes_ was made
	std::vector<char>          isChanged_;              ///< per face
	std::vector<int>           near_;                   ///< faces within reach of the patch
	bool                       intersectsHere_ = false; ///< near the face at hand
	int                        changeNum_      = 0;
	std::int64_t               attempts_       = 0; ///< left
	int                        spare_;

	std::vector<int>       worstFirst(std::vector<int> faces) const;
	std::vector<int>       stillBad(const std::vector<int>& faces) const;
	bool                   isExhausted() const;
	void                   improveAt(int f);
	bool                   takeEach(int f);
	bool                   takeBest(int f);
	std::vector<Operation> bestSingle(int f);
	std::vector<Operation> bestPair(int f);
	void                   keep(const std::vector<Operation>& ops);
	std::vector<int>       patchOf(const std::vector<Operation>& ops);
	void                   note(const std::vector<int>& patch, const std::vector<int>& facesBefore);

	Before                         lookAt(const Operation& op, const std::vector<int>& patch);
	Before                         lookAt(PatchEditor::Snapshot snapshot);
	std::vector<int>               facesNow(const Before& before) const;
	float                          attempt(const Operation& op, Before before, float known);
	float                          gainOver(const Before& before);
	bool                           keepsLimits(Before& before);
	std::unique_ptr<PatchDistance> distanceOf(const std::vector<int>& faces,
											  const Triangles& triangles, float edge);
	bool keepsDistance(const PatchDistance* distance, const std::vector<int>& faces);
	bool looksForContacts() const { return goal_->limits.contacts || goal_->contactCost > 0; }
	bool limitsGaps() const { return goal_->limits.gap < HUGE_VALF; }
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
	void flipIfBetter(int h, const std::vector<int>& patch);
	bool moveToBest(int v);
	bool stepFrom(int v, float reach, float& cost);

	/// The number of intersecting pairs with a face of `faces` (ascending) and a face of near_.
	int              intersectionNum(const std::vector<int>& faces);
	void             findNear(int f);
	std::vector<int> facesMeeting(const Box<float>& box) const;
	void             lookForIntersections(int f);
	std::vector<int> ringsRound(int f, int ringNum);
};

} // namespace gpr

#endif
