// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_THREE_MF_H
#define VCG_EXTRAS_IO_FORMATS_THREE_MF_H

#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <string_view>

// 3MF, a format of printers, by the library lib3mf.

namespace gpr::app {

/// Whether this build has the library.
bool hasThreeMf();

/// Reads the triangles of all objects that the file builds as one mesh, each object at its place.
/// Coordinates are floats, in the unit of the file. Throws AppError (BadInput).
InputMesh readThreeMf(std::string_view file);

/// Writes a single object with about seven digits. The format's unit stays millimetres. Throws
/// AppError (Failure).
void writeThreeMf(const TriangleMesh& mesh, OutputFile& out);

} // namespace gpr::app

#endif
