// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_THIN_BORDER_H
#define VCG_EXTRAS_CORE_INPUT_THIN_BORDER_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Takes thin faces (isThin, with a margin) at the border of a part of a mesh out of the part, and
/// thin faces that touch such faces, and so on. The border of a part keeps its edges, so each such
/// face would give a degenerate face in any result. isInPart: per face. A part of such faces only
/// stays as it is. Cost: a pass over the faces, and another pass if some faces are thin.
void takeOutThinBorder(const MeshView& input, std::vector<std::uint8_t>& isInPart);

} // namespace gpr

#endif
