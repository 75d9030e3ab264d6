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

	/// Of the finite corners of the faces.
	explicit ShownFrame(const MeshView& mesh);

	Vec3d local(const Vec3d& p) const { return (p - centre) * scale; }
};

/// The triangles of a mesh that are drawn, in the frame of the picture.
struct ShownMesh {
	std::vector<float>         positions; ///< 3 a vertex
	std::vector<std::uint32_t> triangles; ///< 3 vertices a triangle
	std::vector<std::uint32_t> faceOf;    ///< for each triangle, the face of the mesh that it shows
};

/// All faces of the mesh with three finite, different corners. Where there are more than mostFaces,
/// vertices in the same cell of a grid are drawn as one (Rossignac and Borrel 1993), and those
/// faces remain whose corners are in three cells. Cost: linear, a few times.
ShownMesh shownMesh(const MeshView& mesh, const ShownFrame& frame, std::size_t mostFaces);

} // namespace gpr::app

#endif
