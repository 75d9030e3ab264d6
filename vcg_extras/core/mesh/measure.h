// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_MEASURE_H
#define VCG_EXTRAS_CORE_MESH_MEASURE_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Counts and topology of any set of triangles, manifold or not. Components are faces linked over
/// edges; border loops are the connected sets of edges with one face; the Euler characteristic
/// counts used vertices only. Indices must be in range. Cost: O(F log F), serial; for `gpremesh
/// info` and faulty input.
MeshFigures measureMesh(const MeshView& mesh);

/// Shape measures of the triangles; valence6Percent is over inner vertices. A face with a corner
/// that is not finite counts as degenerate.
QualityFigures measureQuality(const MeshView& mesh, Workers& workers);
QualityFigures measureQuality(const MeshView& mesh, int threads = 1);

/// 2·inradius/circumradius of every face, 1 = equilateral, 0 = degenerate. Cost: linear.
std::vector<float> radiusRatios(const MeshView& mesh, Workers& workers);

/// Counts and topology of a half-edge mesh; lengths in mesh units times `unit`. Cost: linear,
/// parallel.
MeshFigures figuresOf(const HalfEdgeMesh& mesh, double unit, Workers& workers);

/// Total length of the border, in mesh units. size: per vertex, a factor on the unit there; empty:
/// 1 everywhere. Cost: a pass over the half-edges.
double borderLength(const HalfEdgeMesh& mesh, const Buffer<float>& size = {});

/// Number of degenerate faces. Cost: a parallel pass.
std::int64_t zeroAreaFaceNum(const HalfEdgeMesh& mesh, Workers& workers);
/// Number of faces with an area, in working units, of mere rounding. Cost: a parallel pass.
std::int64_t lineFaceNum(const HalfEdgeMesh& mesh, Workers& workers);

} // namespace gpr

#endif
