// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_MESH_EDIT_H
#define VCG_EXTRAS_CORE_MESH_MESH_EDIT_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <vector>

namespace gpr {

/// All changes of topology. Every change has a test, which may refuse, and keeps the mesh an
/// oriented 2-manifold of the same topology; positions and shapes are the caller's matter.
/// Feature lines (HalfEdgeMesh::crease) are kept too: their edges are never flipped, their vertices
/// are merged by canCollapseAlongCrease only, and both halves of an edge have the same mark. In
/// half of a symmetric mesh no inner edge may join two vertices of the mirror plane, as its mirror
/// image would be a second edge with the same ends.
/// A dead face has origin[3f] = -1, a dead vertex outgoing[v] = -1.

inline bool isDeadFace(const HalfEdgeMesh& m, int f)
{
	return m.origin[3 * f] < 0;
}

/// Working memory of the tests, reused between calls.
struct EditScratch {
	std::vector<int> ringA;
	std::vector<int> count;
};

/// Whether the inner vertex origin[h] may be merged into target(h): the link condition (Dey et al.
/// 1999) holds, and every vertex keeps enough faces. Never for vertices of curves: see
/// canCollapseAlongBorder and canCollapseAlongCrease.
bool canCollapse(const HalfEdgeMesh& m, int h, EditScratch& scratch);

/// Whether origin[h], an inner vertex on exactly one feature line, may be merged into target(h),
/// the next vertex of the line, by collapse(). False if two curves would merge.
bool canCollapseAlongCrease(const HalfEdgeMesh& m, int h, EditScratch& scratch);

/// Merges origin[h] into target(h) over an inner edge; origin[h] must be an inner vertex.
void collapse(HalfEdgeMesh& m, int h);

/// Whether border vertex v may be merged into its next (forward) or previous border vertex. False
/// if a feature line ends in v.
bool canCollapseAlongBorder(const HalfEdgeMesh& m, int v, bool forward, EditScratch& scratch);
void collapseAlongBorder(HalfEdgeMesh& m, int v, bool forward);
/// The next (forward) or previous border vertex.
int borderNeighbour(const HalfEdgeMesh& m, int v, bool forward);

/// Whether the inner edge h, off the feature lines, may be flipped.
bool canFlip(const HalfEdgeMesh& m, int h);
/// Replaces edge a-b by d-c, with c = apex(h) and d = apex(opposite). h becomes a -> d, in the face
/// of a, d and c.
void flip(HalfEdgeMesh& m, int h);

/// Puts newVertex on the inner edge h. The two new faces get the next two numbers; the arrays must
/// have room.
void splitEdge(HalfEdgeMesh& m, int h, int newVertex);

/// Puts newVertex on the border edge h. The new face gets the next number. newVertex becomes the
/// border vertex after origin[h].
void splitBorderEdge(HalfEdgeMesh& m, int h, int newVertex);

/// Puts newVertex inside face f. The two new faces get the next two numbers.
void splitFace(HalfEdgeMesh& m, int f, int newVertex);

/// The star of a vertex, counter-clockwise. Places of the ring count from 0; edge i of the ring
/// runs from place i to the next place. For a border vertex the ring is a path from the next border
/// vertex to the previous border vertex; the last edge, back to place 0, is not in the mesh.
struct VertexStar {
	int              vertex   = -1;
	bool             isClosed = true;
	std::vector<int> ring;  ///< neighbours
	std::vector<int> spoke; ///< half-edges from the vertex to places 0, 1, ..., one a face

	int placeNum() const { return int(ring.size()); }
};
void collectStar(const HalfEdgeMesh& m, int v, VertexStar& star);

/// The triangles that close the hole of a removed vertex: two triangles fewer than places, linked
/// over diagonals.
struct HolePatch {
	std::vector<int> corner; ///< places of the ring, three a triangle, counter-clockwise
	std::vector<int> across; ///< per edge, from corner k to the next corner of the triangle: the k
							 ///< of the other side of a diagonal, or -1 - i for edge i of the ring

	int triangleNum() const { return int(corner.size()) / 3; }
};

/// Whether the patch, a triangulation of the ring, may replace the star: no diagonal may be an edge
/// of the mesh already, and every vertex must keep enough faces. Never for vertices of feature
/// lines. Cost: a walk round a vertex per diagonal.
bool canRemoveVertex(const HalfEdgeMesh& m, const VertexStar& star, const HolePatch& patch,
					 EditScratch& scratch);

/// Removes the star's vertex and closes the hole by the patch. At a border the ring's last edge
/// becomes border; a border vertex with a single face loses only the face.
void removeVertex(HalfEdgeMesh& m, const VertexStar& star, const HolePatch& patch,
				  EditScratch& scratch);

/// A copy of some vertices and faces, which can undo changes. Changes must not write to others: to
/// undo flips, splits and collapses, `vertices` must include all corners of the changed faces, and
/// of the faces beyond the two faces of a collapse, and `faces` all faces at these vertices.
class PatchBackup {
public:
	PatchBackup(const HalfEdgeMesh& mesh, std::vector<int> vertices, std::vector<int> faces);

	const std::vector<int>& vertices() const { return vertex_; }
	const std::vector<int>& faces() const { return face_; }

	/// Restores the copy; drops vertices and faces appended later.
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

/// Enlarges the arrays for so many vertices and faces, and keeps their content.
void reserve(HalfEdgeMesh& m, int vertexRoom, int faceRoom);

/// Drops dead faces and vertices, in order, and unused room; newIndex[v] is the new number of v, or
/// -1. Cost: linear, parallel; little if nothing is dead.
void compact(HalfEdgeMesh& m, Workers& workers, Buffer<int>& newIndex);

/// A copy with the same vertices and faces, without unused room.
HalfEdgeMesh copyMesh(const HalfEdgeMesh& from, Workers& workers);

} // namespace gpr

#endif
