// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_MESH_SOURCE_H
#define VCG_EXTRAS_IO_MESH_MESH_SOURCE_H

#include "attribute_carry.h"
#include "mesh_data.h"

#include <memory>

namespace gpr::app {

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
