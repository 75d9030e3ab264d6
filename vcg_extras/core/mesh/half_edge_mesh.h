// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_HALF_EDGE_MESH_H
#define VCG_EXTRAS_CORE_MESH_HALF_EDGE_MESH_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/vec.h>

#include <vector>

namespace gpr {

/// Half-edge h belongs to face h / 3; the three of a face follow each other.
inline int nextInFace(int h)
{
	return unsigned(h) % 3 == 2 ? h - 2 : h + 1;
}
inline int prevInFace(int h)
{
	return unsigned(h) % 3 == 0 ? h + 2 : h - 1;
}

/// Triangle mesh as flat arrays: 32 B a face in all.
///
///            c
///          /   \        half-edge h runs from origin[h] = a to origin[nextInFace(h)] = b,
///         /  f  \       opposite[h] is b -> a in the neighbour, or -1 at a border.
///        a --h--> b
///
/// outgoing[v] is a half-edge leaving v; at a border vertex the one that is itself a border, so
/// that one turn (forEachOutgoing) sees the whole fan. -1 where v is in no face.
struct HalfEdgeMesh {
	int           vertexNum = 0;
	int           faceNum   = 0;
	Buffer<Vec3f> position; ///< of at least vertexNum
	Buffer<int>   origin;   ///< of at least 3·faceNum
	Buffer<int>   opposite;
	Buffer<int>   outgoing;
	/// Per half-edge: 1 on feature lines, at both halves of an edge. Empty where there are none.
	Buffer<char> crease;
	/// Where the mesh is half of a symmetric one: the axis on whose plane at 0 its border meets its
	/// mirror image; the other vertices have coordinates above 0 there. -1: it is no half.
	int mirrorAxis = -1;
	/// Vertices at one place are one vertex, of several sheets: faces there do not touch.
	bool meetsAtPlaces = false;

	int halfEdgeNum() const { return 3 * faceNum; }
	int target(int h) const { return origin[nextInFace(h)]; }
	int apex(int h) const { return origin[prevInFace(h)]; }

	bool isBorderEdge(int h) const { return opposite[h] < 0; }
	/// True for vertices of a border and for those in no face.
	bool isBorderVertex(int v) const { return outgoing[v] < 0 || opposite[outgoing[v]] < 0; }
	bool hasCreases() const { return !crease.empty(); }
	bool isCreaseEdge(int h) const { return hasCreases() && crease[h] != 0; }
	/// Of the border or of a feature line: edges that stay edges, whatever happens round them.
	bool isCurveEdge(int h) const { return isBorderEdge(h) || isCreaseEdge(h); }
	/// Feature lines that meet in v; at the border without the border's own edges.
	int  creaseNum(int v) const;
	bool isCreaseVertex(int v) const { return hasCreases() && creaseNum(v) > 0; }
	/// Vertices that move along a curve only, if at all.
	bool isCurveVertex(int v) const { return isBorderVertex(v) || isCreaseVertex(v); }

	/// Whether a vertex is its own mirror image.
	bool isOnMirror(int v) const
	{
		return mirrorAxis >= 0 && coordinate(position[v], mirrorAxis) == 0;
	}

	/// A place for v: on the mirror plane where v lies on it.
	template <class S>
	Vec3<S> keptOnMirror(int v, Vec3<S> place) const
	{
		if (isOnMirror(v)) setCoordinate(place, mirrorAxis, S(0));
		return place;
	}

	/// Area times two times the unit normal.
	Vec3f faceCross(int f) const
	{
		const Vec3f a = position[origin[3 * f]];
		return cross(position[origin[3 * f + 1]] - a, position[origin[3 * f + 2]] - a);
	}
	Vec3f faceNormal(int f) const { return normalized(faceCross(f)); }

	Vec3f faceCentre(int f) const
	{
		Vec3f centre;
		for (int h = 3 * f; h < 3 * f + 3; ++h)
			centre += position[origin[h]] * (1 / 3.0f);
		return centre;
	}

	/// Half-edge a -> b, or -1.
	int findHalfEdge(int a, int b) const;
	/// Either half-edge of the edge of a and b, a -> b if there is one; or -1.
	int findEdge(int a, int b) const;
	/// Whether a and b are joined by an edge, seen from a; also over a border edge b -> a.
	bool areNeighbours(int a, int b) const;
	/// Number of faces at v.
	int valence(int v) const;
	/// The border half-edge that ends in the border vertex v.
	int incomingBorder(int v) const;
};

/// Calls visit(h) for every half-edge that leaves v, counter-clockwise; at a border beginning
/// there. The mesh must not grow meanwhile, here and below: its arrays are looked up once, as what
/// `visit` writes could change them for all that the compiler knows.
template <class Visit>
inline void forEachOutgoing(const HalfEdgeMesh& m, int v, const Visit& visit)
{
	const int first = m.outgoing[v];
	if (first < 0) return;
	const int* const opposite = m.opposite.data();
	int              h        = first;
	do {
		visit(h);
		h = opposite[prevInFace(h)];
	} while (h >= 0 && h != first);
}

/// Calls visit(h, a, b) for every half-edge h that leaves v, as above; a and b lead from v to the
/// other corners of h's face, target(h) and apex(h), where vertex w lies at at(w). Each place of
/// the ring is asked for once only.
template <class At, class Visit>
inline void forEachFaceRound(const HalfEdgeMesh& m, int v, const At& at, const Visit& visit)
{
	const int first = m.outgoing[v];
	if (first < 0) return;
	const int* const opposite = m.opposite.data();
	const int* const origin   = m.origin.data();
	const Vec3f      p        = at(v);
	Vec3f            a        = at(m.target(first)) - p;
	int              h        = first;
	do {
		const int   in = prevInFace(h);
		const Vec3f b  = at(origin[in]) - p;
		visit(h, a, b);
		a = b;
		h = opposite[in];
	} while (h >= 0 && h != first);
}

/// The same with the mesh's own places.
template <class Visit>
inline void forEachFaceRound(const HalfEdgeMesh& m, int v, const Visit& visit)
{
	const Vec3f* const position = m.position.data();
	forEachFaceRound(
		m, v, [position](int w) { return position[w]; }, visit);
}

/// Calls visit(w) for every neighbour w of v, the one behind the last border edge included.
template <class Visit>
inline void forEachNeighbour(const HalfEdgeMesh& m, int v, const Visit& visit)
{
	const int first = m.outgoing[v];
	if (first < 0) return;
	const int* const opposite = m.opposite.data();
	const int* const origin   = m.origin.data();
	visit(m.target(first));
	int h = first;
	for (;;) {
		// The neighbour before is the next one's target, but here it need not wait for `next`.
		const int in   = prevInFace(h);
		const int next = opposite[in];
		if (next == first) return;
		visit(origin[in]);
		if (next < 0) return;
		h = next;
	}
}

/// The faces at any of the vertices, ascending.
std::vector<int> facesRound(const HalfEdgeMesh& mesh, const std::vector<int>& vertices);
/// The corners of all the faces, ascending.
std::vector<int> verticesOf(const HalfEdgeMesh& mesh, const std::vector<int>& faces);

/// The vertices and faces as callers' meshes are seen. The mesh must stay where it is.
MeshView viewOf(const HalfEdgeMesh& mesh);

} // namespace gpr

#endif
