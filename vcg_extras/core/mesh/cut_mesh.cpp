// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_mesh.h"

#include "mesh_edit.h"

#include <vcg_extras/core/base/sort_unique.h>

namespace gpr {

namespace {

/// Half-edges from v on lines or the border, counter-clockwise: the beginnings of v's sectors.
std::vector<int> sectorsAt(const HalfEdgeMesh& m, const Buffer<char>& lines, int v)
{
	std::vector<int> first;
	forEachOutgoing(m, v, [&](int h) {
		if (lines[h] || m.isBorderEdge(h)) first.push_back(h);
	});
	return first;
}

} // namespace

CutMesh cutAlong(const HalfEdgeMesh& m, const Buffer<char>& lines, Workers& workers)
{
	std::vector<int> onLine;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (lines[h]) onLine.push_back(m.origin[h]);
	}
	sortUnique(onLine);
	CutMesh          cut;
	std::vector<int> first; // half-edges of the copies
	for (const int v : onLine) {
		const std::vector<int> sectors = sectorsAt(m, lines, v);
		for (std::size_t i = 1; i < sectors.size(); ++i) {
			cut.copyOf.push_back(v);
			first.push_back(sectors[i]);
		}
	}
	HalfEdgeMesh& to = cut.mesh;
	to               = copyMesh(m, workers);
	to.vertexNum     = m.vertexNum + int(first.size());
	reserve(to, to.vertexNum, to.faceNum);
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (lines[h]) to.opposite[h] = -1;
	}
	for (const int v : onLine)
		to.outgoing[v] = sectorsAt(m, lines, v).front();
	for (std::size_t i = 0; i < first.size(); ++i) {
		const int copy    = m.vertexNum + int(i);
		to.position[copy] = m.position[cut.copyOf[i]];
		to.outgoing[copy] = first[i];
		forEachOutgoing(to, copy, [&](int h) { to.origin[h] = copy; });
	}
	return cut;
}

} // namespace gpr
