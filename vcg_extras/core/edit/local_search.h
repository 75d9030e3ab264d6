// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_LOCAL_SEARCH_H
#define VCG_EXTRAS_CORE_EDIT_LOCAL_SEARCH_H

#include "face_trials.h"
#include "failed_attempts.h"
#include "goal.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace gpr {

/// Improves the worst faces of the result in turn, by the trials of FaceTrials. A face without a
/// helpful operation is left alone until the mesh near the face changes. Flips and moves are tried
/// at several faces at the same time, with claims on the mesh round each (see Claims); all other
/// searches try one face after the other. The outcome does not depend on threads.
class LocalSearch {
public:
	/// assignment: may be null if no goal limits distances. work: the work left for all runs, also
	/// of further searches, see workOf; counts down. Reserves memory for spareVertexNum vertices.
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
	PatchEditor                   editor_;
	const HalfEdgeMesh&           m_;
	Assignment*                   assignment_;
	Workers&                      workers_;
	std::int64_t&                 work_; ///< left
	const Goal*                   goal_ = nullptr;
	FailedAttempts                failed_{0};
	std::vector<int>              touched_; ///< vertices that changed in this round
	std::unique_ptr<FacesInSpace> space_;   ///< made on first use
	std::unique_ptr<Claims>       claims_;  ///< made on first use
	int                           changeNum_ = 0;
	std::int64_t                  attempts_  = 0; ///< left
	int                           spare_;

	/// Faces to try at the same time, with the names of their claims.
	struct Batch {
		std::vector<int> face, claim;
	};

	std::vector<int> worstFirst(std::vector<int> faces) const;
	bool             isExhausted() const;
	bool             looksForContacts() const;
	void             takeSpace();
	bool             takesSeveral() const;
	bool             mayImprove(int f) const;
	void             improveAll(const std::vector<int>& faces);
	Batch            takeSome(std::deque<int>& waiting);
	void             improve(const Batch& batch);
	void             note(int f, const FaceTrials& trials);
};

} // namespace gpr

#endif
