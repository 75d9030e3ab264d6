// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_OBJ_FORMAT_H
#define VCG_EXTRAS_APPS_GPREMESH_OBJ_FORMAT_H

#include "mesh_data.h"
#include "output_file.h"

#include <string_view>

namespace gpr::app {

/// Reads the positions and faces of a Wavefront OBJ file that lies in memory; all else is passed
/// over. Indices may count from the begin or back from the end; polygons are cut into triangles.
/// Own code because vcglib's reader of 2020.09 drops every face that uses the first vertex and
/// takes words for zeros. Throws AppError (BadInput) on a malformed v or f line.
InputMesh readObj(std::string_view file);

/// Writes positions and faces, coordinates with all digits of a double or of a float.
void writeObj(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out);

} // namespace gpr::app

#endif
