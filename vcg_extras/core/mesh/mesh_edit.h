// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_MESH_EDIT_H
#define VCG_EXTRAS_CORE_MESH_MESH_EDIT_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <vector>

namespace gpr {

/// The only place where topology changes. Every change has a test that can refuse it and keeps the
/// mesh an oriented 2-manifold of the same topology; positions and shapes are the caller's matter.
/// Feature lines (HalfEdgeMesh::crease) are kept too: their edges are never flipped, their vertices
/// are only merged by canCollapseAlongCrease, and both halves of an edge stay marked alike.
/// Where the mesh is half of a symmetric one no inner edge may join two vertices of the mirror
/// plane: its mirror image would be a second edge between them.
/// A dead face has origin[3f] = -1, a dead vertex outgoing[v] = -1.

inline bool isDeadFace(const HalfEdgeMesh& m, int f)
{
	return m.origin[3 * f] < 0;
}

/// Working memory of the tests, reused from call to call.
struct EditScratch {
	std::vector<int> ringA;
	std::vector<int> count;
};

/// Whether the inner vertex origin[h] may be merged into target(h): the link condition (Dey et al.
/// 1999), and no vertex may be left with too few faces. Never for vertices of curves: see
/// canCollapseAlongBorder and canCollapseAlongCrease.
bool canCollapse(const HalfEdgeMesh& m, int h, EditScratch& scratch);

/// Whether origin[h], an inner vertex that exactly one feature line passes, may be merged into the
/// next vertex of that line, target(h), by collapse(). No two curves may fall together by it.
bool canCollapseAlongCrease(const HalfEdgeMesh& m, int h, EditScratch& scratch);

/// Merges origin[h] into target(h) over an inner edge; origin[h] must be an inner vertex.
void collapse(HalfEdgeMesh& m, int h);

/// Whether the border vertex v may be merged into its next (forward) or previous border vertex. Not
/// where a feature line ends in v.
bool canCollapseAlongBorder(const HalfEdgeMesh& m, int v, bool forward, EditScratch& scratch);
void collapseAlongBorder(HalfEdgeMesh& m, int v, bool forward);
/// The border vertex that v would be merged into.
int borderNeighbour(const HalfEdgeMesh& m, int v, bool forward);

/// Whether the inner edge h, of no feature line, may be turned to join its two apexes.
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

/// Puts newVertex inside face f; the two new faces take the next two numbers.
void splitFace(HalfEdgeMesh& m, int f, int newVertex);

/// A vertex and what lies round it, counter-clockwise. Places of the ring are counted from 0; edge
/// i of the ring runs from place i to the next. Round a border vertex the ring is a path from the
/// next border vertex to the previous one, and its last edge, back to place 0, is not in the mesh.
struct VertexStar {
	int              vertex   = -1;
	bool             isClosed = true;
	std::vector<int> ring;  ///< neighbours
	std::vector<int> spoke; ///< half-edges from the vertex to places 0, 1, ..., one a face

	int placeNum() const { return int(ring.size()); }
};
void collectStar(const HalfEdgeMesh& m, int v, VertexStar& star);

/// Triangles that close the hole a vertex leaves: two fewer than its ring has places, joined by
/// diagonals.
struct HolePatch {
	std::vector<int> corner; ///< places of the ring, three a triangle, counter-clockwise
	std::vector<int> across; ///< beyond the edge from corner k to the next of its triangle: the
							 ///< diagonal's other k, or -1 - i for edge i of the ring

	int triangleNum() const { return int(corner.size()) / 3; }
};

/// Whether patch is a triangulation of the star's ring, taken as a polygon without inner points,
/// that may take the place of the star: none of its diagonals may be an edge of the mesh, and no
/// vertex may be left with too few faces. Never for vertices of feature lines. Cost: a turn round a
/// vertex per diagonal.
bool canRemoveVertex(const HalfEdgeMesh& m, const VertexStar& star, const HolePatch& patch,
					 EditScratch& scratch);

/// Takes the star's vertex out and closes the hole by the patch. At a border the ring's last edge
/// becomes border; a border vertex of one face only loses that.
void removeVertex(HalfEdgeMesh& m, const VertexStar& star, const HolePatch& patch,
				  EditScratch& scratch);

/// The faces round some vertices as they are: takes any changes among them back. No change may have
/// written to faces elsewhere: all corners of what is flipped, split or collapsed must be among the
/// vertices, the faces' beyond the two of a collapse too.
class PatchBackup {
public:
	PatchBackup(const HalfEdgeMesh& mesh, const std::vector<int>& vertices);
	/// Of these faces alone.
	PatchBackup(const HalfEdgeMesh& mesh, std::vector<int> vertices, std::vector<int> faces);

	const std::vector<int>& vertices() const { return vertex_; }
	const std::vector<int>& faces() const { return face_; }

	/// Puts all back; vertices and faces appended since are dropped.
	void restore(HalfEdgeMesh& mesh) const;

private:
	struct Corner {
		int  origin, opposite;
		char crease;
	};
	int                 vertexNum_, faceNum_;
	std::vector<int>    vertex_, face_, outgoing_;
	std::vector<Vec3f>  position_;
	std::vector<Corner> corner_; ///< three a face
};

/// Makes room for so many vertices and faces, keeping what is there.
void reserve(HalfEdgeMesh& m, int vertexRoom, int faceRoom);

/// Drops dead faces and vertices, keeping order, and all room beyond the others; newIndex[v] is the
/// vertex' new place or -1. Cost: linear, parallel; little where nothing is dead.
void compact(HalfEdgeMesh& m, Workers& workers, Buffer<int>& newIndex);

/// A mesh of its own with the same vertices and faces, and no room beyond them.
HalfEdgeMesh copyMesh(const HalfEdgeMesh& from, Workers& workers);

} // namespace gpr

#endif
