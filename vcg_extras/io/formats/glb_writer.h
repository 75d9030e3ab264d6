// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_GLB_WRITER_H
#define VCG_EXTRAS_IO_FORMATS_GLB_WRITER_H

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_attributes.h>

#include <string>
#include <vector>

namespace gpr::app {

/// Writes a binary glTF 2.0 file of one mesh, with texture coordinates, colours and normals of the
/// vertices, and materials, if any; names the lost rest. glTF has one texture coordinate for each
/// vertex, so vertices along seams are written more than once. Materials of a glTF input are
/// written unchanged, with their images; images and materials of other files by their names. The
/// format holds floats only. Throws AppError (Failure) for more than 4 GB.
void writeGlb(const TriangleMesh& mesh, const MeshAttributes& attributes, OutputFile& out,
			  std::vector<std::string>& lost);

/// The same as text, with the buffer inside. Needs hasGltfText().
void writeGltf(const TriangleMesh& mesh, const MeshAttributes& attributes, OutputFile& out,
			   std::vector<std::string>& lost);

/// One level of detail.
struct GlbLevel {
	TriangleMesh   mesh;
	MeshAttributes attributes;
	double         largestError = 0; ///< proven, mesh units
};

/// Writes a binary glTF file whose node has several levels by the extension MSFT_lod, the finest
/// first. Each node tells its largest error in its extras. The materials of the first level are
/// those of all. Throws as writeGlb.
void writeGlbLevels(const std::vector<GlbLevel>& levels, OutputFile& out);

} // namespace gpr::app

#endif
