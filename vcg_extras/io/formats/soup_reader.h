// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_SOUP_READER_H
#define VCG_EXTRAS_IO_FORMATS_SOUP_READER_H

#include <vcg_extras/io/mesh/mesh_data.h>

#include <string_view>

// OBJ, OFF and STL. The files lie in memory, and all but ASCII STL are read in pieces by all
// threads. Returned indices are in range, and nothing is lost silently. The readers throw AppError
// (BadInput) on anything malformed or cut off.

namespace gpr::app {

/// Positions and faces; all else is passed over. Indices count from the begin or from the end.
/// holdsMore: whether there are colours, texture, normals, materials or groups, see
/// obj_attributes.h.
InputMesh readObj(std::string_view file, bool& holdsMore);
InputMesh readObj(std::string_view file);

/// ASCII, one vertex and one face a line; text after the coordinates and the corners on a line is
/// passed over.
InputMesh readOff(std::string_view file);

/// ASCII or binary, for any first word; corners at exactly the same position become one vertex, in
/// the order of their first use. ASCII: keywords in any case, names of any words, several solids,
/// which are regions of faces; a note tells of a solid without end.
InputMesh readStl(std::string_view file);

/// A binary STL file of at least the promised length.
InputMesh readBinaryStl(std::string_view file);

} // namespace gpr::app

#endif
