// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_zoo.h"

#include "mesh_builders.h"
#include "transforms.h"

namespace gpr::test {

namespace {

///      2
///     /|\.     Every side of a triangle has a neighbour: the smallest closed surface.
///    / 3 \.
///   0-----1
TriangleMesh tetrahedron()
{
	return {{{0, 0, 0}, {1, 0, 0}, {0.5, 0.9, 0}, {0.5, 0.3, 0.8}},
			{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
}

///   3---2
///   | / |       The smallest mesh with an inner edge.
///   0---1
TriangleMesh twoTriangles()
{
	return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3}};
}

///   3---2
///   |\ /|      The smallest mesh with an inner vertex of four faces.
///   | 4 |
///   |/ \|
///   0---1
TriangleMesh squareWithCentre()
{
	return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
			{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4}};
}

/// A ring of six triangles between a small and a large triangle: two loops of three edges.
TriangleMesh triangularRing()
{
	return {{{-2, -1, 0}, {2, -1, 0}, {0, 3, 0}, {-0.5, 0, 0}, {0.5, 0, 0}, {0, 1, 0}},
			{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5}};
}

/// Two tetrahedra with the common vertex 0: each is closed, but the vertex has two fans.
TriangleMesh pinchedTetrahedra()
{
	TriangleMesh mesh = joined(tetrahedron(), shifted(tetrahedron(), {-2, 0, 0}));
	for (std::int32_t& v : mesh.triangles)
		v = v == 4 ? 0 : v;
	return withoutUnused(mesh);
}

/// Seven vertices, every two joined by an edge: the smallest torus (Möbius 1861, Császár 1949).
TriangleMesh csaszarTorus()
{
	return {{{3, -3, 0}, {-3, 3, 0}, {-3, -3, 1}, {3, 3, 1}, {-1, -2, 3}, {1, 2, 3}, {0, 0, 15}},
			{0, 1, 2, 0, 2, 5, 0, 5, 4, 0, 4, 6, 0, 6, 3, 0, 3, 1, 1, 3, 4,
			 1, 4, 5, 1, 5, 6, 1, 6, 2, 2, 6, 4, 2, 4, 3, 2, 3, 5, 3, 6, 5}};
}

} // namespace

std::vector<ZooMesh> meshZoo()
{
	const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}}, {0, 1, 2}};
	TriangleMesh       opposed = twoTriangles();
	std::swap(opposed.triangles[4], opposed.triangles[5]);
	TriangleMesh doubled = twoTriangles();
	doubled.triangles.insert(doubled.triangles.end(), {1, 2, 0});
	return {
		{"triangle", triangle, true, 1, 1, 1},
		{"twoTriangles", twoTriangles(), true, 1, 1, 1},
		{"squareWithCentre", squareWithCentre(), true, 1, 1, 1},
		{"triangularRing", triangularRing(), true, 1, 2, 0},
		{"tetrahedron", tetrahedron(), true, 1, 0, 2},
		{"icosahedron", icosphere(0), true, 1, 0, 2},
		{"cubeOfTwelve", cube(1), true, 1, 0, 2},
		{"sevenVertexTorus", csaszarTorus(), true, 1, 0, 0},
		{"twoTetrahedra", joined(tetrahedron(), shifted(tetrahedron(), {3, 0, 0})), true, 2, 0, 4},
		{"threeFins", finsOnEdge(3), false, 1, 1, 1},
		{"bowTie", fansSharingVertex(2), false, 2, 1, 1},
		{"pinchedTetrahedra", pinchedTetrahedra(), false, 2, 0, 3},
		{"opposedTriangles", opposed, false, 1, 1, 1},
		{"doubledFace", doubled, false, 1, 1, 2},
		{"moebiusStrip", moebiusStrip(5, 1), false, 1, 1, 0},
	};
}

} // namespace gpr::test
