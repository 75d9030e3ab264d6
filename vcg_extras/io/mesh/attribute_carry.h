// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_ATTRIBUTE_CARRY_H
#define VCG_EXTRAS_IO_MESH_ATTRIBUTE_CARRY_H

#include "mesh_attributes.h"

#include <vcg_extras/core/remesh.h>

#include <memory>

namespace gpr::app {

/// How values of vertices come to a result.
enum class Transfer {
	Auto,   ///< the mean, but labels, and colours that are a palette, of the nearest corner
	Mean,   ///< the same with the mean of all colours
	Nearest ///< all of the nearest corner
};

/// Takes the texture out of the attributes of a mesh; null where there is none. Texture coordinates
/// of vertices are a texture where the mesh is sewn and they differ between vertices at one place:
/// once these are one vertex, only corners can tell its two sides. The mesh must outlive the
/// result.
std::unique_ptr<TextureSource> takeTexture(MeshAttributes& attributes, const MeshView& mesh,
										   bool isSewn);

/// Carries attributes over to a result: of vertices the mean over the corners of the face that each
/// lies on, the nearest corner's for whole numbers that are no colours, and for colours that are a
/// palette: few, and mostly the same at both ends of an edge; of faces those of the face
/// that the middle of each lies on; texture coordinates by `texture`, or none where it is null.
/// Normals are made unit vectors again; faces' normals are lost. Needs the surface points of the
/// result's faces where faces have any. The source is emptied on the way. Cost: linear in the
/// result.
MeshAttributes carryAttributes(MeshAttributes& source, const MeshView& mesh,
							   const TextureSource* texture, const RemeshResult& result,
							   Transfer transfer = Transfer::Auto);

} // namespace gpr::app

#endif
