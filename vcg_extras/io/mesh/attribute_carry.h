// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_ATTRIBUTE_CARRY_H
#define VCG_EXTRAS_IO_MESH_ATTRIBUTE_CARRY_H

#include "mesh_data.h"

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

/// Whether runs with these options sew seams.
bool isSewn(const RemeshOptions& options);

/// A mesh to remesh, with the data for its result.
struct MeshSource {
	InputMesh                      mesh;
	std::unique_ptr<TextureSource> texture; ///< or null; looks at the mesh's arrays

	MeshSource() = default;
	/// Takes the texture out of the attributes, as a run with these options needs the texture.
	MeshSource(InputMesh input, const RemeshOptions& options);

	/// The view for the engine: seams of the texture are lines.
	MeshView view() const;
	/// Whether carrying attributes over takes places of the result's faces, and any places at all.
	bool needsPointsOfFaces() const { return texture != nullptr || mesh.attributes.ofFacesToo(); }
	bool needsPoints() const { return needsPointsOfFaces() || mesh.attributes.any(); }
	/// The options, with the places on the surface by which attributes are carried over.
	RemeshOptions withPlaces(const RemeshOptions& options) const;
};

/// Whether a result is written in double: for a double input, and if floats would not resolve a
/// thousandth of the mean edge.
bool needsDoubleOutput(const InputMesh& input, const RemeshResult& result);

} // namespace gpr::app

#endif
