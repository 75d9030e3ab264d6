// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_GIVEN_LINES_H
#define VCG_EXTRAS_CORE_FEATURES_GIVEN_LINES_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>

#include <cstdint>

namespace gpr {

/// Whether the input mesh has MeshView::line, or faces of different regions. Cost: O(F).
bool hasGivenLines(const MeshView& input);

/// Adds the lines of the input mesh to the feature lines of the surface: the edges in
/// MeshView::line, and the edges between faces of different regions, with all parts of split edges;
/// no border edges. Returns the number of surface edges added. Needs: connect(). Cost: linear,
/// parallel.
std::int64_t markGivenLines(const MeshView& input, Workers& workers, Surface& surface);

} // namespace gpr

#endif
