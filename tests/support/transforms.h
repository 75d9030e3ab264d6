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
/// Both meshes as one mesh without common vertices.
TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b);
/// The same surface with vertices and faces in random order and each face's first corner at random.
TriangleMesh shuffled(const TriangleMesh& mesh, Random& random);
/// Every face turned over.
TriangleMesh insideOut(const TriangleMesh& mesh);
/// The mesh with separate vertices for the faces of each part; partOf: a number for each face.
TriangleMesh cutApart(const TriangleMesh& mesh, const std::vector<int>& partOf);
/// The sides of a cube, each with vertices of its own.
TriangleMesh cubeOfSides(int n);
/// A square in the plane through the z axis at angleRad; a side of the square lies on the axis.
TriangleMesh page(int n, double angleRad);
/// Doubles the inner vertex v and joins both vertices by an edge: on one side of the edge is a hole
/// of three edges without area, on the other side a degenerate face.
TriangleMesh withSlit(const TriangleMesh& mesh, int v);
/// Makes the middle of the edge from corner `at` (place in the list of corners) a vertex of this
/// face alone, with a degenerate face between the middle and the face beyond the edge.
TriangleMesh withFlatFace(const TriangleMesh& mesh, std::size_t at);
/// The mesh without vertices outside of faces.
TriangleMesh withoutUnused(const TriangleMesh& mesh);

/// A mesh in single precision, as most readers deliver.
struct FloatMesh {
	std::vector<Vec3f>        positions;
	std::vector<std::int32_t> triangles;

	explicit FloatMesh(const TriangleMesh& mesh);
	MeshView view() const { return MeshView(positions, triangles); }
};

} // namespace gpr::test

#endif
