// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_VERTEX_REMOVAL_H
#define VCG_EXTRAS_CORE_VERTEX_REMOVAL_H

#include "blocks.h"
#include "boundary_curves.h"
#include "front_sampling.h"
#include "result_mesh.h"

namespace gpr {

/// Stage 7: retriangulation (paper §3, last paragraph) by label-guided removal.
///
/// Differs from the paper, whose samples are fused into the mesh by edge splits and whose holes are
/// closed in a local parametrization: here one vertex of each Voronoi cell stands for its sample,
/// every other vertex is merged into a neighbour of the same cell, the one that leaves the best
/// worst triangle, and the last vertex of a cell takes the sample's place. Later passes allow any
/// cell, then any geometry, so that only what the topology needs is left over. Border vertices move
/// along their border only. Topology is kept by construction (see mesh_edit.h).
///
/// Works block by block: no edge grows beyond a quarter of a cell, so that two blocks of a colour
/// never touch the same vertex; what that forbids is done in the end, serially.
/// Cost: about one collapse a vertex, 3 M/s a core.
ResultMesh removeVertices(const Surface& surface, const Sampling& sampling,
						  const BoundaryCurves& boundary, const BlockPartition& partition,
						  Workers& workers);

/// Collapses what another removal had to leave: each of the vertices is merged into whichever
/// neighbour leaves the best worst triangle, under looser and looser geometry. rest keeps those
/// that the topology needs. Cost: a few vertices, serially.
void collapseRest(HalfEdgeMesh& m, std::vector<int>& rest, Workers& workers);

} // namespace gpr

#endif
