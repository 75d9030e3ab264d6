// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_SOUP_WRITER_H
#define VCG_EXTRAS_IO_FORMATS_SOUP_WRITER_H

#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_data.h>

// Positions and triangles alone, as OFF and STL files.

namespace gpr::app {

/// Coordinates with the fewest digits that give back each double, or each float.
void writeOff(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out);

/// Binary. The format holds floats only.
void writeStl(const TriangleMesh& mesh, OutputFile& out);

} // namespace gpr::app

#endif
