// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_GLB_READER_H
#define VCG_EXTRAS_IO_FORMATS_GLB_READER_H

#include <vcg_extras/io/mesh/mesh_data.h>

#include <string_view>

namespace gpr::app {

/// Reads the triangles of a binary glTF file's scene as one mesh, each at the place of its node;
/// with attributes if wanted: the first texture coordinates, the first colours, normals, and
/// materials. Coordinates are floats, or doubles if a node has moved the mesh so far that floats
/// would not resolve the mesh. Texture coordinates count from the lower left corner, as in the
/// other formats. Points and lines are left out, with a note. Throws AppError (BadInput) on
/// anything malformed, and for compression, morph targets, sparse data and data in other files.
InputMesh readGlb(std::string_view file, const WantedAttributes& wanted);
/// With all attributes.
InputMesh readGlb(std::string_view file);

} // namespace gpr::app

#endif
