// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_VORONOI_DUAL_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_VORONOI_DUAL_H

#include "sampled_result.h"

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/sampling/front_sampling.h>

#include <vector>

namespace gpr {

/// The surface after most Voronoi cells were contracted to a vertex each. The other cells are open:
/// they have all their vertices, which are to be merged into a single vertex per cell. The vertex
/// of a contracted cell has surfaceVertex -1.
struct VoronoiDual : Retriangulated {
	std::vector<int> label; ///< per vertex: the sample of its cell
};

/// Stage::Retriangulation, first half: makes the dual of the Voronoi cells. A face with corners in
/// three cells becomes a triangle of their samples; every other face vanishes. Merging the vertices
/// of each cell one by one would give the same mesh; this takes a pass over the faces.
///
/// The dual has the topology of the surface only if cells are disks and two cells meet in at most
/// one piece. A cell is a disk if the Euler characteristic of its vertices, edges and faces is 1. A
/// cell meets its neighbours well if its vertex has a single fan of at least three triangles, with
/// no edge used twice in the same direction. Other cells and cells on feature lines are left open
/// for removeVertices, which keeps the topology by construction; so are their neighbours that would
/// touch an open vertex in two places. All cells are left open if the mesh differs from `input` in
/// components, border loops or Euler characteristic, or if more than half of the cells would be
/// open.
/// Cost: some passes over the faces, parallel; ten times cheaper than collapses.
VoronoiDual makeVoronoiDual(const Surface& surface, const Sampling& sampling,
							const BoundaryCurves& boundary, const MeshFigures& input,
							Workers& workers);

} // namespace gpr

#endif
