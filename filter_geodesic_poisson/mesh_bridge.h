// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_MESH_BRIDGE_H
#define FILTER_GEODESIC_POISSON_MESH_BRIDGE_H

// Between MeshLab's mesh and the engine's flat arrays.

#include <common/ml_mesh_type.h>
#include <cstdint>
#include <vcg_extras/core/remesh.h>
#include <vector>

namespace gpr_filter {

/// A copy of what the engine and the carrying over need of a layer, without its deleted elements.
/// A copy and no view: while the filter runs, the host's progress bar lets the user start other
/// filters on the same layer, and they may move its vectors under the engine's threads.
struct LayerCopy {
	std::vector<gpr::Vec3<Scalarm>>    positions;
	std::vector<std::int32_t>          triangles; ///< 3 indices a face
	std::vector<vcg::Color4b>          colours;   ///< one a vertex, or none
	std::vector<CVertexO::QualityType> qualities; ///< one a vertex, or none

	gpr::MeshView view() const { return gpr::MeshView(positions, triangles); }
	/// Bit by bit, so that a NaN equals itself.
	bool sameGeometry(const LayerCopy& other) const;
};

/// Copies a mesh, with or without its vertex colours and qualities.
LayerCopy copyLayer(const CMeshO& mesh, bool withColour, bool withQuality);

/// Fills an empty mesh with the result; colours and qualities that the copy has are interpolated at
/// the anchors. Normals and box are not computed. Throws std::bad_alloc only.
void buildMesh(const gpr::RemeshResult& result, const LayerCopy& source, CMeshO& built);

/// Puts the vertices and faces of `built` in the place of those of `layer`, and removes what
/// belonged to the old ones: edges, per-element attributes, textures, selection counts. Optional
/// components must have been disabled before. Needs no memory, so it does not fail half-way.
void replaceContents(CMeshO& layer, CMeshO& built);

} // namespace gpr_filter

#endif
