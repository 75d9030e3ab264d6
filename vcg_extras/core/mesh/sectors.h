// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_SECTORS_H
#define VCG_EXTRAS_CORE_MESH_SECTORS_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

namespace gpr {

/// Feature lines cut the ring of a vertex into sectors, each of which is a piece of its own as the
/// ring of a border vertex is: flat or not, with as many faces as its angle wants.

/// Faces farther than this (about 37°) from their mean normal are not flat.
constexpr float flatCosine = 0.8f;

/// Calls visit(first, faceNum) for every sector of v: the faces from that of the half-edge `first`
/// on, counter-clockwise. One sector where no feature line meets v.
template <class Visit>
inline void forEachSector(const HalfEdgeMesh& m, int v, const Visit& visit)
{
	int start = m.outgoing[v], valence = 0, creases = 0;
	forEachOutgoing(m, v, [&](int h) {
		++valence;
		if (!m.isCreaseEdge(h)) return;
		++creases;
		if (!m.isBorderVertex(v)) start = h;
	});
	if (creases == 0) {
		visit(start, valence);
		return;
	}
	int first = start, num = 0, h = start;
	for (int i = 0; i < valence; ++i) {
		if (num > 0 && m.isCreaseEdge(h)) {
			visit(first, num);
			first = h;
			num   = 0;
		}
		++num;
		h = m.opposite[prevInFace(h)];
	}
	visit(first, num);
}

/// Faces at v, corrected so that 6 is right everywhere: a sector, or the ring of a border vertex,
/// wants as many faces as angles of 60° fit into it, and one at least.
int correctedValence(const HalfEdgeMesh& mesh, int v);

/// Whether the faces of each sector of v lie within about 37° of their mean normal.
bool isFlat(const HalfEdgeMesh& mesh, int v);

/// The same for all vertices. Moving one that is not flat would round off what is sharp there.
Buffer<char> findFlatVertices(const HalfEdgeMesh& mesh, Workers& workers);

} // namespace gpr

#endif
