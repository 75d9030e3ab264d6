// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_SEAM_EDGES_H
#define VCG_EXTRAS_CORE_FEATURES_SEAM_EDGES_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>

#include <vector>

namespace gpr {

/// Finds the edges of a surface along which the input mesh was sewn: the input faces on both sides
/// have fewer than two common vertices. Returns the smaller half-edge of each edge, ascending.
/// Needs: connected, sourceFace, and an input that was not welded as a triangle soup. Cost: linear,
/// parallel.
std::vector<int> findSeamEdges(const MeshView& input, const Surface& surface, Workers& workers);

} // namespace gpr

#endif
