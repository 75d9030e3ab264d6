// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_VIEWER_SHOWN_MESH_H
#define VCG_EXTRAS_VIEWER_SHOWN_MESH_H

#include <vcg_extras/core/mesh_view.h>

namespace gpr::app {

/// The frame of a picture: the middle of a mesh is the origin, the diagonal of its box is 1.
struct ShownFrame {
	Vec3d  centre;
	double scale = 1;

	/// The frame of the finite corners of the faces.
	explicit ShownFrame(const MeshView& mesh);

	Vec3d local(const Vec3d& p) const { return (p - centre) * scale; }
};

/// The drawn triangles of a mesh, in the frame of the picture.
struct ShownMesh {
	std::vector<float>         positions; ///< 3 a vertex
	std::vector<std::uint32_t> triangles; ///< 3 vertices a triangle
	std::vector<std::uint32_t> faceOf;    ///< for each triangle, its face of the mesh
};

/// All faces of the mesh with three finite, different corners. Of more than mostFaces faces the
/// vertices in the same cell of a grid are drawn as a vertex (Rossignac and Borrel 1993), and only
/// faces with corners in three cells remain. Cost: linear, a few times.
ShownMesh shownMesh(const MeshView& mesh, const ShownFrame& frame, std::size_t mostFaces);

} // namespace gpr::app

#endif
