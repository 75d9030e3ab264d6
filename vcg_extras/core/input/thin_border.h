// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_THIN_BORDER_H
#define VCG_EXTRAS_CORE_INPUT_THIN_BORDER_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Takes the faces without area (isThin, with a margin) at the border of a part of a mesh out of
/// the part, and those that touch them, and so on. The border of a part is to stay as it is: with
/// such a face at it there would be triangles without area in any result. isInPart: per face. A
/// part that would be empty stays as it is. Cost: a pass over the faces, and another one where some
/// are thin.
void takeOutThinBorder(const MeshView& input, std::vector<std::uint8_t>& isInPart);

} // namespace gpr

#endif
