// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_VERTEX_REMOVAL_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_VERTEX_REMOVAL_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Stage::Retriangulation (paper §3, last paragraph), by Voronoi cells.
///
/// Differs from the paper, which fuses the samples into the mesh by edge splits and closes holes in
/// a local parametrization. Here the vertices of each Voronoi cell are merged into a single vertex
/// at the place of the sample, for most cells in one step (voronoi_dual.h). In cells with a risk
/// for the topology a vertex represents the sample; every other vertex is merged into the neighbour
/// of the same cell that gives the best worst triangle. Later passes allow neighbours of any cell,
/// then any geometry, so that only vertices stay that the topology needs. Border vertices move
/// along their border only. Each edit keeps the topology (mesh_edit.h).
///
/// input: components, border loops and Euler characteristic of the surface. Works in cubes of
/// space; vertices with neighbours out of reach come last, serially. Cost: some passes over the
/// faces, and a collapse for each vertex of an open cell, 2 M/s a core.
ResultMesh removeVertices(const Surface& surface, const Sampling& sampling,
						  const BoundaryCurves& boundary, const MeshFigures& input,
						  Workers& workers);

/// Collapses the vertices that a removal left in `rest`: merges each vertex into the neighbour that
/// gives the best worst triangle, under ever looser geometry. Vertices that the topology needs
/// remain in `rest`. label: per vertex, its Voronoi cell; empty: vertices are not first merged
/// within their cells. Cost: a few vertices, serial.
void collapseRest(HalfEdgeMesh& m, const std::vector<int>& label, std::vector<int>& rest,
				  Workers& workers);

} // namespace gpr

#endif
