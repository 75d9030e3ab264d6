// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_SEAM_EDGES_H
#define VCG_EXTRAS_CORE_FEATURES_SEAM_EDGES_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>

#include <vector>

namespace gpr {

/// The edges of a surface along which the caller's mesh was sewn: their two faces come from faces
/// of the caller's that have fewer than two vertices in common. Each by its smaller half-edge,
/// ascending. Needs: connected, sourceFace, and that the mesh was not welded as a triangle soup.
/// Cost: linear, parallel.
std::vector<int> findSeamEdges(const MeshView& input, const Surface& surface, Workers& workers);

} // namespace gpr

#endif
