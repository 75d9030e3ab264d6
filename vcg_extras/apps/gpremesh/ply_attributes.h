// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_PLY_ATTRIBUTES_H
#define VCG_EXTRAS_APPS_GPREMESH_PLY_ATTRIBUTES_H

#include "mesh_data.h"

#include <string_view>

namespace gpr::app {

/// Reads vertex quality and selection of a PLY file that lies in memory into the mesh that readPly
/// has made of it. Names are MeshLab's: the vertices' property "quality"; in "flags" of vertices
/// and faces the bit that says selected. A property "selected" that is not 0 says so, too. Where
/// no vertex is selected, the corners of selected faces are.
/// A second way through the file, value by value, so that reading stays fast where nobody asks.
/// Throws AppError (BadInput) where a wanted attribute is missing or a value malformed.
void readPlyAttributes(std::string_view file, const WantedAttributes& wanted, InputMesh& mesh);

} // namespace gpr::app

#endif
