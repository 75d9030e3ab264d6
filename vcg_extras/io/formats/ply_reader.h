// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_PLY_READER_H
#define VCG_EXTRAS_IO_FORMATS_PLY_READER_H

#include <vcg_extras/io/mesh/mesh_data.h>

#include <string_view>

namespace gpr::app {

/// Reads a PLY file in memory: ASCII and both binary forms, properties of any type in any order,
/// unused elements, polygons, triangle strips. Triangles of the usual layout are read at the speed
/// of copying. Positions are double if x, y or z is stored as double or as a 32-bit whole number.
/// Throws AppError (BadInput) for a malformed or cut-off file, or an index out of range; sizes are
/// checked against the file's length before memory is taken.
InputMesh readPly(std::string_view file);

/// The same, but usable positions and triangles stay in place in the file, as in most scans:
/// InputMesh::inFile. The bytes of the file must then outlive the mesh.
InputMesh lookAtPly(std::string_view file);

} // namespace gpr::app

#endif
