// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_PLY_ATTRIBUTES_H
#define VCG_EXTRAS_IO_FORMATS_PLY_ATTRIBUTES_H

#include <vcg_extras/io/mesh/mesh_data.h>

#include <string_view>

namespace gpr::app {

/// Reads the wanted attributes of a PLY file in memory into the mesh of readPly. Names are
/// MeshLab's: the vertices' property "quality"; a bit for the selection in "flags" of vertices and
/// faces. A property "selected" other than 0 selects, too. If vertices are wanted and no vertex is
/// selected, the corners of selected faces are selected. All other scalar properties are carried,
/// and the texture coordinates "texcoord" and "texnumber" of faces; other lists are named in
/// `lost`. A second pass over the file, value by value, so that reading stays fast for files
/// without attributes. Throws AppError (BadInput) for a missing required attribute or a malformed
/// value.
void readPlyAttributes(std::string_view file, const WantedAttributes& wanted, InputMesh& mesh);

} // namespace gpr::app

#endif
