// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_GIVEN_LINES_H
#define VCG_EXTRAS_CORE_FEATURES_GIVEN_LINES_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>

#include <cstdint>

namespace gpr {

/// Whether the caller's mesh has lines of its own: MeshView::line, or borders between regions.
bool hasGivenLines(const MeshView& input);

/// Adds the caller's lines to the feature lines of a surface that was made of the caller's mesh:
/// those of MeshView::line, and the edges between faces of different regions. Edges of the border
/// are none. Returns the number of edges added. Long edges that were split are found piece by
/// piece. Needs: connected. Cost: linear, parallel.
std::int64_t markGivenLines(const MeshView& input, Workers& workers, Surface& surface);

} // namespace gpr

#endif
