// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_EXACT_COUNT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_EXACT_COUNT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// The wanted number of vertices, or of faces if faces are counted; in half a symmetric mesh, of
/// the whole mesh.
struct CountTarget {
	std::int64_t vertexNum = 0;
	std::int64_t faceNum   = 0; ///< if not 0, vertexNum is ignored

	bool isGiven() const { return vertexNum > 0 || faceNum > 0; }
};

/// Stage::Count: splits or collapses edges of the result until the result has exactly the wanted
/// number of vertices or faces. An inner vertex adds two faces, a border vertex adds one face: if
/// the wanted and the present number of faces differ in parity, first the longest border edge is
/// split, or a border edge is collapsed if none may be split. In half a symmetric mesh the same
/// holds for vertices: a vertex on the mirror plane adds one vertex to the whole mesh, any other
/// vertex adds two vertices.
///
/// Edges are chosen by valence: for each edge the change of Σ(valence - 6)² is computed, for splits
/// with up to two flips round the new vertex; the lowest change goes first, then the longest edge
/// to split and the shortest edge to collapse. A change of 0 moves a dislocation and makes no new
/// dislocation, so that the triangles stay regular. First only edges on flat ground are taken, then
/// any edge with sound shapes, then any edge that the topology allows. Returns false if the
/// topology allows no more collapses; the mesh then has the nearest possible number. Cost: a pass
/// over the edges per round, some rounds.
bool reachExactCount(const Surface& surface, const BoundaryCurves& boundary,
					 const CountTarget& target, ResultMesh& result, Workers& workers);

/// The same, but dead faces and vertices stay in the mesh, which must have none before.
bool changeCount(const Surface& surface, const BoundaryCurves& boundary, const CountTarget& target,
				 ResultMesh& result, Workers& workers);

/// The same by topology only, regardless of shapes: the last resort for tiny counts. Choice and
/// order of the edges do not depend on the target. So the function can reach every count between
/// the count at the start and the count reached for a target of 1 vertex.
bool reachCountByTopology(const Surface& surface, const BoundaryCurves& boundary,
						  const CountTarget& target, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
