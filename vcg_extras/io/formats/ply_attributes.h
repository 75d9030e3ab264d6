// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_PLY_ATTRIBUTES_H
#define VCG_EXTRAS_IO_FORMATS_PLY_ATTRIBUTES_H

#include <vcg_extras/io/mesh/mesh_data.h>

#include <string_view>

namespace gpr::app {

/// Reads what is wanted beside the mesh of a PLY file that lies in memory into the mesh that
/// readPly has made of it. Names are MeshLab's: the vertices' property "quality"; in "flags" of
/// vertices and faces the bit that says selected. A property "selected" that is not 0 says so, too.
/// Where vertices are wanted and none is selected, the corners of selected faces are. Carried are
/// all scalar properties but those, and the texture coordinates "texcoord" and "texnumber" of
/// faces; other lists are named in `lost`. A second way through the file, value by value, so that
/// reading stays fast where there is nothing to read. Throws AppError (BadInput) where something
/// required is missing or a value malformed.
void readPlyAttributes(std::string_view file, const WantedAttributes& wanted, InputMesh& mesh);

} // namespace gpr::app

#endif
