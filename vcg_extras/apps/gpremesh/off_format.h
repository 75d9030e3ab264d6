// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_OFF_FORMAT_H
#define VCG_EXTRAS_APPS_GPREMESH_OFF_FORMAT_H

#include "mesh_data.h"
#include "output_file.h"

#include <string_view>

namespace gpr::app {

/// Reads an ASCII OFF file that lies in memory: [ST][C][N]OFF, one vertex and one face a line, what
/// follows the coordinates and the corners on a line is passed over. Own code because vcglib's
/// reader trusts the indices and goes on past the end of a file that is cut off.
/// Throws AppError (BadInput) on anything malformed.
InputMesh readOff(std::string_view file);

/// Writes positions and faces, coordinates with all digits of a double or of a float.
void writeOff(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out);

} // namespace gpr::app

#endif
