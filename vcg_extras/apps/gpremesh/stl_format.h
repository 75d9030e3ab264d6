// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_STL_FORMAT_H
#define VCG_EXTRAS_APPS_GPREMESH_STL_FORMAT_H

#include "mesh_data.h"
#include "output_file.h"

#include <string_view>

namespace gpr::app {

/// Reads an STL file that lies in memory, ASCII or binary, whatever its first word claims; corners
/// at exactly the same position become one vertex. Own code because vcglib's reader never returns
/// from a file without a line break and takes ASCII numbers through float.
/// Throws AppError (BadInput) on anything malformed or cut off.
InputMesh readStl(std::string_view file);

/// Writes a binary STL file. The format holds floats only.
void writeStl(const TriangleMesh& mesh, OutputFile& out);

} // namespace gpr::app

#endif
