// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_EXACT_COUNT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_EXACT_COUNT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// How many vertices a result is to have; or how many faces, where that is what was asked for.
struct CountTarget {
	std::int64_t vertexNum = 0;
	std::int64_t faceNum   = 0; ///< where it is not 0 the number of vertices follows from it

	bool isGiven() const { return vertexNum > 0 || faceNum > 0; }
};

/// Stage::Count: splits or collapses edges of the result until it has exactly as many vertices or
/// faces as wanted. A vertex inside brings two faces, one of the border one: where the wanted
/// number of faces is odd and the result's is even, or the other way round, a border edge is split
/// first, the longest one, or one is collapsed where none may be split.
///
/// Which ones is chosen by valence: of every edge the change of Σ(valence - 6)² is worked out, for
/// splits together with up to two flips round the new vertex; lowest first, then the longest edge
/// to split and the shortest to collapse. A change of 0 moves a dislocation instead of making one,
/// so the triangles stay as regular as they were. Only edges on flat ground are taken at first,
/// then any, then whatever the topology allows. Returns false where the topology allows no more
/// collapses; the mesh is then as near as it gets. Cost: a pass over the edges per round, some
/// rounds.
bool reachExactCount(const Surface& surface, const BoundaryCurves& boundary,
					 const CountTarget& target, ResultMesh& result, Workers& workers);

/// The same, leaving dead faces and vertices in the mesh: those that it had, and new ones.
bool changeCount(const Surface& surface, const BoundaryCurves& boundary, const CountTarget& target,
				 ResultMesh& result, Workers& workers);

/// The same by topology alone, whatever the shapes: the last resort for tiny counts. Which edges
/// are taken, and in which order, does not depend on the target, so that every count between the
/// one it starts from and the one it ends at for one vertex can be reached.
bool reachCountByTopology(const Surface& surface, const BoundaryCurves& boundary,
						  const CountTarget& target, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
