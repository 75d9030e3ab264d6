// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_mesh.h"

#include <vcg_extras/core/base/sort_unique.h>

#include <algorithm>

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

template <class T>
Buffer<T> copied(const Buffer<T>& from, std::size_t num, std::size_t more)
{
	Buffer<T> to(num + more);
	std::copy(from.begin(), from.begin() + std::ptrdiff_t(num), to.begin());
	return to;
}

} // namespace

CutMesh cutAlong(const HalfEdgeMesh& m, const Buffer<char>& lines)
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
	const std::size_t vertexNum = std::size_t(m.vertexNum), edgeNum = std::size_t(m.halfEdgeNum());
	HalfEdgeMesh&     to = cut.mesh;
	to.faceNum           = m.faceNum;
	to.vertexNum         = m.vertexNum + int(first.size());
	to.position          = copied(m.position, vertexNum, first.size());
	to.outgoing          = copied(m.outgoing, vertexNum, first.size());
	to.origin            = copied(m.origin, edgeNum, 0);
	to.opposite          = copied(m.opposite, edgeNum, 0);
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
