// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_PLY_WRITER_H
#define VCG_EXTRAS_IO_FORMATS_PLY_WRITER_H

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_attributes.h>

namespace gpr::app {

/// Writes a binary little endian PLY file with positions as double or float, triangles, and every
/// attribute with its name and type; texture coordinates of corners as in MeshLab, in a list
/// 'texcoord' of each face.
void writePly(const MeshView& mesh, bool doublePrecision, const MeshAttributes& attributes,
			  OutputFile& out);

} // namespace gpr::app

#endif
