// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_VORONOI_DUAL_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_VORONOI_DUAL_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/sampling/front_sampling.h>

#include <vector>

namespace gpr {

/// The surface with most Voronoi cells drawn together to one vertex each. Cells that could not be
/// are open: all their vertices are still there, but for one of each they are to be merged away.
struct VoronoiDual {
	HalfEdgeMesh     mesh;
	std::vector<int> label;         ///< per vertex: the sample whose cell it is or belongs to
	std::vector<int> surfaceVertex; ///< per vertex: the surface's vertex it is; -1: a whole cell
	std::vector<int> sampleVertex;  ///< per sample: the vertex that is or stands for it; -1: none
	std::vector<int> todo;          ///< vertices to be merged away
	std::int64_t     openCellNum = 0;
};

/// Stage::Retriangulation, first half: the dual of the Voronoi cells. A face whose corners lie in
/// three cells becomes a triangle between their samples, every other face vanishes: what merging
/// the vertices of each cell one by one would end with, in one pass over the faces.
///
/// That is a mesh of the same topology only where cells are disks that meet each other in one piece
/// at most. A cell is a disk if its vertices, edges and faces have the Euler characteristic 1; a
/// cell that meets its neighbours well has a single fan of at least three triangles, with no edge
/// used twice in one direction. Cells that fail, those on feature lines, and the cells next to
/// them are left open for the removal of vertices, which keeps the topology by construction. Where
/// the mesh that comes out has not the components, boundary loops and Euler characteristic of
/// `input`, or more than half of the cells would be open, all are.
/// Cost: some passes over the faces, parallel; ten times cheaper than collapses.
VoronoiDual makeVoronoiDual(const Surface& surface, const Sampling& sampling,
							const BoundaryCurves& boundary, const MeshFigures& input,
							Workers& workers);

} // namespace gpr

#endif
