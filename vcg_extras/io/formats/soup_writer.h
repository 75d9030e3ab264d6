// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_SOUP_WRITER_H
#define VCG_EXTRAS_IO_FORMATS_SOUP_WRITER_H

#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_data.h>

// Positions and triangles, and in STL their regions, as OFF and STL files.

namespace gpr::app {

/// Coordinates with the fewest digits from which each double, or each float, can be read.
void writeOff(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out);

/// Binary, which holds floats only; ASCII with a solid for each of several regions. Names the
/// attributes that STL does not hold.
void writeStl(const TriangleMesh& mesh, bool doublePrecision, const MeshAttributes& attributes,
			  OutputFile& out, std::vector<std::string>& lost);

} // namespace gpr::app

#endif
