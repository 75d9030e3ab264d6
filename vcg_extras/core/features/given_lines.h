// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_GIVEN_LINES_H
#define VCG_EXTRAS_CORE_FEATURES_GIVEN_LINES_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Whether the input mesh has MeshView::line, or faces of different regions. Cost: O(F).
bool hasGivenLines(const MeshView& input);

/// Adds the lines of the input mesh to the feature lines of the surface: the edges in
/// MeshView::line, and the edges between faces of different regions, with all parts of split edges;
/// no border edges. Returns the number of surface edges added. Needs: connect(). Cost: linear,
/// parallel.
std::int64_t markGivenLines(const MeshView& input, Workers& workers, Surface& surface);

/// Finds the edges of a surface along which the input mesh was sewn: the input faces on both sides
/// have fewer than two common vertices. Returns the smaller half-edge of each edge, ascending.
/// Needs: connected, sourceFace, and an input that was not welded as a triangle soup. Cost: linear,
/// parallel.
std::vector<int> findSeamEdges(const MeshView& input, const Surface& surface, Workers& workers);

} // namespace gpr

#endif
