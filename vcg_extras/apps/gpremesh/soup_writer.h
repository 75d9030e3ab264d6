// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_SOUP_WRITER_H
#define VCG_EXTRAS_APPS_GPREMESH_SOUP_WRITER_H

#include "mesh_data.h"
#include "output_file.h"

// Positions and triangles alone, as OBJ, OFF and STL files.

namespace gpr::app {

/// Coordinates with the fewest digits that give back each double, or each float.
void writeObj(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out);
void writeOff(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out);

/// Binary. The format holds floats only.
void writeStl(const TriangleMesh& mesh, OutputFile& out);

} // namespace gpr::app

#endif
