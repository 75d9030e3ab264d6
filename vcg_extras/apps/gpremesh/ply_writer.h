// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_PLY_WRITER_H
#define VCG_EXTRAS_APPS_GPREMESH_PLY_WRITER_H

#include "mesh_data.h"
#include "output_file.h"

namespace gpr::app {

/// Writes a binary little endian PLY file with positions as double or float, and triangles.
void writePly(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out);

} // namespace gpr::app

#endif
