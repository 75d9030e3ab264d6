// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_EDIT_H
#define VCG_EXTRAS_CORE_MESH_EDIT_H

#include "half_edge_mesh.h"
#include "workers.h"

#include <vector>

namespace gpr {

/// The only place where topology changes. Every change has a test that can refuse it and keeps the
/// mesh an oriented 2-manifold of the same topology; positions and shapes are the caller's matter.
/// A dead face has origin[3f] = -1, a dead vertex outgoing[v] = -1.

inline bool isDeadFace(const HalfEdgeMesh& m, int f)
{
	return m.origin[3 * f] < 0;
}

/// Working memory of the tests, reused from call to call.
struct EditScratch {
	std::vector<int> ringA;
};

/// Whether the inner vertex origin[h] may be merged into target(h): the link condition (Dey et al.
/// 1999), and no vertex may be left with too few faces. Border vertices: canCollapseAlongBorder.
bool canCollapse(const HalfEdgeMesh& m, int h, EditScratch& scratch);

/// Merges origin[h] into target(h) over an inner edge; origin[h] must be an inner vertex.
void collapse(HalfEdgeMesh& m, int h);

/// Whether the border vertex v may be merged into its next (forward) or previous border vertex.
bool canCollapseAlongBorder(const HalfEdgeMesh& m, int v, bool forward, EditScratch& scratch);
void collapseAlongBorder(HalfEdgeMesh& m, int v, bool forward);
/// The border vertex that v would be merged into.
int borderNeighbour(const HalfEdgeMesh& m, int v, bool forward);

/// Whether the inner edge h may be turned to join its two apexes.
bool canFlip(const HalfEdgeMesh& m, int h);
/// Turns a-b into d-c, where c = apex(h) and d = apex(opposite): h becomes a -> d in face (a, d,
/// c).
void flip(HalfEdgeMesh& m, int h);

/// Puts newVertex on the inner edge h; the two new faces take the next two numbers, for which there
/// must be room.
void splitEdge(HalfEdgeMesh& m, int h, int newVertex);

/// Puts newVertex on the border edge h; the new face takes the next number. newVertex becomes the
/// border vertex after origin[h].
void splitBorderEdge(HalfEdgeMesh& m, int h, int newVertex);

/// Makes room for so many vertices and faces, keeping what is there.
void reserve(HalfEdgeMesh& m, int vertexRoom, int faceRoom);

/// Drops dead faces and vertices, keeping order; newIndex[v] is the vertex' new place or -1.
void compact(HalfEdgeMesh& m, std::vector<int>& newIndex);

/// A mesh of its own with the same vertices and faces, and no room beyond them.
HalfEdgeMesh copyMesh(const HalfEdgeMesh& from, Workers& workers);

} // namespace gpr

#endif
