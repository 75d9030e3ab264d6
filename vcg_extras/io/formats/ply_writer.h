// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_PLY_WRITER_H
#define VCG_EXTRAS_IO_FORMATS_PLY_WRITER_H

#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_data.h>

namespace gpr::app {

/// What a PLY file holds of every vertex beside its position; what is null is left out.
struct PlyVertexData {
	const float*        quality  = nullptr; ///< one a vertex
	const std::uint8_t* rgb      = nullptr; ///< three a vertex
	const std::uint8_t* selected = nullptr; ///< one a vertex, 0 or 1
};

/// Writes a binary little endian PLY file with positions as double or float, and triangles. Names
/// are MeshLab's; a selected vertex has the bit that says so in "flags".
void writePly(const MeshView& mesh, bool doublePrecision, const PlyVertexData& data,
			  OutputFile& out);
void writePly(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out);

} // namespace gpr::app

#endif
