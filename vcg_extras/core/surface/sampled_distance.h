// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_SAMPLED_DISTANCE_H
#define VCG_EXTRAS_CORE_SURFACE_SAMPLED_DISTANCE_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

namespace gpr {

/// Largest distance found from points of either mesh to the other: the Hausdorff distance,
/// approached from below. The points are the vertices that are in a face and, on faces larger than
/// that, a lattice with a spacing of about a third of the mean edge of the coarser mesh.
/// Cost: O(F log F), parallel but for the two trees.
float largestSampledDistance(const HalfEdgeMesh& a, const HalfEdgeMesh& b, Workers& workers);

/// Largest distance of a vertex of one mesh from the other mesh. Cost: as above.
float largestVertexDistance(const HalfEdgeMesh& from, const HalfEdgeMesh& to, Workers& workers);

} // namespace gpr

#endif
