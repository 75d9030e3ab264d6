// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_VERTEX_REMOVAL_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_VERTEX_REMOVAL_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Stage::Retriangulation (paper §3, last paragraph): by the samples' cells.
///
/// Differs from the paper, whose samples are fused into the mesh by edge splits and whose holes are
/// closed in a local parametrization: here the vertices of each Voronoi cell are merged until one
/// is left, which takes the sample's place. For most cells that is done in one step (see
/// voronoi_dual.h). In cells where that could harm the topology one vertex stands for the
/// sample, and every other one is merged into a neighbour of the same cell, the one that leaves the
/// best worst triangle. Later passes allow any cell, then any geometry, so that only what the
/// topology needs is left over. Border vertices move along their border only. Topology is kept by
/// construction (see mesh_edit.h).
///
/// input: components, boundary loops and Euler characteristic of the surface.
/// Works in cubes of space; what reaches out of them is done in the end, serially.
/// Cost: some passes over the faces; a collapse for each vertex of the cells left open, 2 M/s a
/// core.
ResultMesh removeVertices(const Surface& surface, const Sampling& sampling,
						  const BoundaryCurves& boundary, const MeshFigures& input,
						  Workers& workers);

/// Collapses what another removal had to leave: each of the vertices is merged into whichever
/// neighbour leaves the best worst triangle, under looser and looser geometry. rest keeps those
/// that the topology needs. Cost: a few vertices, serially.
void collapseRest(HalfEdgeMesh& m, std::vector<int>& rest, Workers& workers);

} // namespace gpr

#endif
