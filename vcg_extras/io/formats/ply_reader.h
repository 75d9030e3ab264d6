// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_PLY_READER_H
#define VCG_EXTRAS_IO_FORMATS_PLY_READER_H

#include <vcg_extras/io/mesh/mesh_data.h>

#include <string_view>

namespace gpr::app {

/// Reads a PLY file that lies in memory: ASCII and both binary forms, properties of any type in any
/// order, elements that are of no use here, polygons, triangle strips. Triangles of the usual
/// layout are read at the speed of copying.
/// The binary forms are read by own code, for speed, ASCII by CGAL.
/// Positions are double where x, y or z is stored as double or as a 32-bit whole number.
/// Throws AppError (BadInput) when the file is malformed, cut off, or an index is out of range;
/// sizes are checked against the file's length before memory is asked for.
InputMesh readPly(std::string_view file);

/// The same, but positions and triangles stay where they are if they can be used as they lie in the
/// file, as those of most scans can: InputMesh::inFile. The file's bytes must outlive the mesh
/// then.
InputMesh lookAtPly(std::string_view file);

} // namespace gpr::app

#endif
