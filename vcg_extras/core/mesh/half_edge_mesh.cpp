// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "half_edge_mesh.h"

#include <vcg_extras/core/base/sort_unique.h>

namespace gpr {

int HalfEdgeMesh::findHalfEdge(int a, int b) const
{
	int found = -1;
	forEachOutgoing(*this, a, [&](int h) {
		if (target(h) == b) found = h;
	});
	return found;
}

int HalfEdgeMesh::findEdge(int a, int b) const
{
	const int h = findHalfEdge(a, b);
	return h >= 0 ? h : findHalfEdge(b, a);
}

bool HalfEdgeMesh::areNeighbours(int a, int b) const
{
	return anyNeighbour(*this, a, [&](int w) { return w == b; });
}

int HalfEdgeMesh::valence(int v) const
{
	int n = 0;
	forEachOutgoing(*this, v, [&](int) { ++n; });
	return n;
}

int HalfEdgeMesh::creaseNum(int v) const
{
	int n = 0;
	forEachOutgoing(*this, v, [&](int h) { n += isCreaseEdge(h); });
	return n;
}

int HalfEdgeMesh::incomingBorder(int v) const
{
	int last = -1;
	forEachOutgoing(*this, v, [&](int h) { last = prevInFace(h); });
	return last;
}

std::vector<int> facesRound(const HalfEdgeMesh& m, const std::vector<int>& vertices)
{
	std::vector<int> faces;
	for (int v : vertices)
		forEachOutgoing(m, v, [&](int h) { faces.push_back(h / 3); });
	sortUniqueBelow(m.faceNum, faces);
	return faces;
}

std::vector<int> verticesOf(const HalfEdgeMesh& m, const std::vector<int>& faces)
{
	std::vector<int> vertices;
	for (int f : faces)
		vertices.insert(vertices.end(), &m.origin[3 * f], &m.origin[3 * f] + 3);
	sortUniqueBelow(m.vertexNum, vertices);
	return vertices;
}

std::vector<int> widened(const HalfEdgeMesh& m, std::vector<int> faces, int rings)
{
	for (int ring = 0; ring < rings; ++ring)
		faces = facesRound(m, verticesOf(m, faces));
	return faces;
}

MeshView viewOf(const HalfEdgeMesh& mesh)
{
	MeshView view;
	view.positions           = mesh.position.data();
	view.positionStrideBytes = sizeof(Vec3f);
	view.vertexNum           = std::size_t(mesh.vertexNum);
	view.triangles           = mesh.origin.data();
	view.faceNum             = std::size_t(mesh.faceNum);
	return view;
}

} // namespace gpr
