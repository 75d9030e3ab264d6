// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_TRANSFORMS_H
#define GPR_TESTS_SUPPORT_TRANSFORMS_H

#include "random_source.h"

#include <vcg_extras/core/mesh_view.h>

namespace gpr::test {

TriangleMesh shifted(const TriangleMesh& mesh, const Vec3d& by);
TriangleMesh scaled(const TriangleMesh& mesh, double factor);
/// About an axis through the origin, which need not have length 1.
TriangleMesh rotated(const TriangleMesh& mesh, const Vec3d& axis, double angleRad);
/// Both meshes as one; they share nothing.
TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b);
/// The same surface with vertices and faces in random order and each face's first corner at random.
TriangleMesh shuffled(const TriangleMesh& mesh, Random& random);
/// Every face turned over.
TriangleMesh insideOut(const TriangleMesh& mesh);
/// With vertices of their own for the faces of each part; partOf: one number a face.
TriangleMesh cutApart(const TriangleMesh& mesh, const std::vector<int>& partOf);
/// The sides of a cube, each with vertices of its own.
TriangleMesh cubeOfSides(int n);
/// A square in the plane through the z axis at that angle; a side of it lies on the axis.
TriangleMesh page(int n, double angleRad);
/// Inner vertex v made two at one place, joined by an edge: a hole of three edges without area, and
/// a face without area on the other side of the edge.
TriangleMesh withSlit(const TriangleMesh& mesh, int v);
/// The middle of the edge from corner `at`, a place in the list of corners, becomes a vertex of
/// this face alone: between it and the face beyond the edge comes one without area.
TriangleMesh withFlatFace(const TriangleMesh& mesh, std::size_t at);
/// Without the vertices that are in no face.
TriangleMesh withoutUnused(const TriangleMesh& mesh);

/// The same mesh in single precision, as most readers deliver it.
struct FloatMesh {
	std::vector<Vec3f>        positions;
	std::vector<std::int32_t> triangles;

	explicit FloatMesh(const TriangleMesh& mesh);
	MeshView view() const { return MeshView(positions, triangles); }
};

} // namespace gpr::test

#endif
