// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_CLAIMS_H
#define VCG_EXTRAS_CORE_EDIT_CLAIMS_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Parts of a mesh for operations at the same time. A claim has four rings round a face. Operations
/// change patches of vertices within two rings, and read the faces at the vertices beside: so no
/// operation reads what an operation of another claim writes, and the outcome does not depend on
/// threads.
class Claims {
public:
	explicit Claims(int vertexRoom) :
			owner_(std::size_t(vertexRoom), 0), visitOf_(std::size_t(vertexRoom), 0)
	{
	}

	/// Name of a claim on the whole mesh, for a face that is tried alone.
	static constexpr int everything = -1;

	/// Gives all claims back.
	void clear() { first_ = next_; }
	/// Claims the rings round a face; returns the name of the claim, or 0 if another claim has one
	/// of their vertices. Returns `everything` if the rings have very many vertices, without regard
	/// to other claims. Cost: a look-up for each edge of some 60 vertices; at most of 500, and of
	/// one vertex with any number of neighbours.
	int claim(const HalfEdgeMesh& mesh, int face);
	/// Whether a claim allows changes of the faces round these vertices. Flips and moves within a
	/// claim keep what it allows.
	bool allow(int claim, const std::vector<int>& patch) const;
	/// Work of the last claim: its look-ups.
	std::int64_t work() const { return work_; }

private:
	std::vector<int> owner_;                ///< per vertex: claim, or -claim in the outer rings
	int              first_ = 1, next_ = 1; ///< names of the claims of now: from first to next
	std::vector<int> visitOf_;              ///< per vertex: the last visit
	int              visit_ = 0;
	std::vector<int> reached_;  ///< of the last visit
	std::int64_t     work_ = 0; ///< of the last visit
};

} // namespace gpr

#endif
