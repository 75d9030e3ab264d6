// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "half_edge_mesh.h"

namespace gpr {

int HalfEdgeMesh::findHalfEdge(int a, int b) const
{
	int found = -1;
	forEachOutgoing(*this, a, [&](int h) {
		if (target(h) == b) found = h;
	});
	return found;
}

bool HalfEdgeMesh::areNeighbours(int a, int b) const
{
	bool found = false;
	forEachNeighbour(*this, a, [&](int w) { found = found || w == b; });
	return found;
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

} // namespace gpr
