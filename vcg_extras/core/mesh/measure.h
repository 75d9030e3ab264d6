// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_MEASURE_H
#define VCG_EXTRAS_CORE_MESH_MEASURE_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Counts and topology of any set of triangles, manifold or not: components are faces linked over
/// edges, boundary loops the connected sets of edges with one face, the Euler characteristic counts
/// vertices in use. Indices must be in range. Cost: O(F log F), serial; for `gpremesh info` and
/// dirty input, not for the hot path.
MeshFigures measureMesh(const MeshView& mesh);

/// Shape of the triangles; valence6Percent over vertices not at a border. Faces with a corner that
/// is not finite count as having no area.
QualityFigures measureQuality(const MeshView& mesh, Workers& workers);
QualityFigures measureQuality(const MeshView& mesh, int threads = 1);

/// 2·inradius/circumradius of every face, 1 = equilateral; 0 for faces without area. Cost: linear.
std::vector<float> radiusRatios(const MeshView& mesh, Workers& workers);

/// The same figures of a half-edge mesh, whose topology is known; lengths in the mesh's units times
/// unit. Cost: linear.
MeshFigures figuresOf(const HalfEdgeMesh& mesh, double unit, Workers& workers);

/// Of all edges with one face, in the mesh's units. Cost: a pass over the half-edges.
double borderLength(const HalfEdgeMesh& mesh);

/// Faces without area. Cost: a parallel pass.
std::int64_t zeroAreaFaceNum(const HalfEdgeMesh& mesh, Workers& workers);
/// Faces whose area, in working units, is nothing but rounding. Cost: a parallel pass.
std::int64_t lineFaceNum(const HalfEdgeMesh& mesh, Workers& workers);

} // namespace gpr

#endif
