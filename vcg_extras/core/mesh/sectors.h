// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_SECTORS_H
#define VCG_EXTRAS_CORE_MESH_SECTORS_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

namespace gpr {

/// Feature lines cut the star of a vertex into sectors. Like the star of a border vertex, each
/// sector is flat or not, and its angle decides the wanted number of faces.

/// Cosine of the largest angle (about 37°) of faces that count as flat with their mean normal.
constexpr float flatCosine = 0.8f;

/// Calls visit(first, faceNum) for every sector of v: faceNum faces, counter-clockwise from the
/// face of half-edge `first`. The whole star is one sector if no feature line meets v.
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

/// Number of faces at v, corrected so that 6 is ideal everywhere: the ideal of a sector, or of the
/// star of a border vertex, is the number of 60° angles in its angle, and at least 1.
int correctedValence(const HalfEdgeMesh& mesh, int v);

/// Whether the faces of each sector of v lie within about 37° of their mean normal.
bool isFlat(const HalfEdgeMesh& mesh, int v);

/// Marks flat vertices. Moving other vertices would round off sharp features.
Buffer<char> findFlatVertices(const HalfEdgeMesh& mesh, Workers& workers);

} // namespace gpr

#endif
