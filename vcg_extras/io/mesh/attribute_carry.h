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
	Auto,   ///< the mean; for labels and colours of a palette the value of the nearest corner
	Mean,   ///< the same with the mean of all colours
	Nearest ///< all of the nearest corner
};

/// Takes the texture out of the attributes of a mesh; null without a texture. Texture coordinates
/// of vertices are a texture if the mesh is sewn and the coordinates differ between vertices at the
/// same place: once these vertices are one, only corners can tell both sides apart. The mesh must
/// outlive the result.
std::unique_ptr<TextureSource> takeTexture(MeshAttributes& attributes, const MeshView& mesh,
										   bool isSewn);

/// Carries attributes over to a result. Vertices get the mean over the corners of the face below,
/// or the value of the nearest corner for whole numbers other than colours and for colours of a
/// palette (few colours, mostly the same at both ends of an edge). Faces get the values of the
/// input face at their middle. Texture coordinates come from `texture`, if not null. Normals are
/// made unit vectors again; normals of faces are lost. Needs the surface points of the result's
/// faces if faces have attributes. The source is emptied on the way. Cost: linear in the result.
MeshAttributes carryAttributes(MeshAttributes& source, const MeshView& mesh,
							   const TextureSource* texture, const RemeshResult& result,
							   Transfer transfer = Transfer::Auto);

} // namespace gpr::app

#endif
