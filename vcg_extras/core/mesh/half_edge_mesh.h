// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_HALF_EDGE_MESH_H
#define VCG_EXTRAS_CORE_MESH_HALF_EDGE_MESH_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/float4.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/vec.h>

#include <vector>

namespace gpr {

/// Half-edge h belongs to face h / 3; the half-edges of a face have consecutive numbers.
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
/// outgoing[v] is a half-edge from v, for a border vertex the border half-edge, so that a single
/// walk (forEachOutgoing) visits the whole fan. -1 if v is in no face.
struct HalfEdgeMesh {
	int           vertexNum = 0;
	int           faceNum   = 0;
	Buffer<Vec3f> position; ///< at least vertexNum entries
	Buffer<int>   origin;   ///< at least 3·faceNum entries
	Buffer<int>   opposite;
	Buffer<int>   outgoing;
	/// Per half-edge: 1 on feature lines, at both halves of an edge. Empty without feature lines.
	Buffer<char> crease;
	/// For half of a symmetric mesh: the axis perpendicular to the mirror plane at 0; else -1. The
	/// border of the cut lies on the plane; all other vertices have coordinates above 0 on this
	/// axis.
	int mirrorAxis = -1;
	/// Vertices at the same place count as a single vertex of several sheets: faces do not touch
	/// there.
	bool meetsAtPlaces = false;

	int halfEdgeNum() const { return 3 * faceNum; }
	int target(int h) const { return origin[nextInFace(h)]; }
	int apex(int h) const { return origin[prevInFace(h)]; }

	bool isBorderEdge(int h) const { return opposite[h] < 0; }
	/// True also for vertices in no face.
	bool isBorderVertex(int v) const { return outgoing[v] < 0 || opposite[outgoing[v]] < 0; }
	bool hasCreases() const { return !crease.empty(); }
	bool isCreaseEdge(int h) const { return hasCreases() && crease[h] != 0; }
	/// Whether an edge is on the border or a feature line: every edit keeps such edges.
	bool isCurveEdge(int h) const { return isBorderEdge(h) || isCreaseEdge(h); }
	/// Number of edges of feature lines at v, without border edges.
	int  creaseNum(int v) const;
	bool isCreaseVertex(int v) const { return hasCreases() && creaseNum(v) > 0; }
	/// Whether v moves along a curve only, if at all.
	bool isCurveVertex(int v) const { return isBorderVertex(v) || isCreaseVertex(v); }

	/// Whether a vertex lies on the mirror plane.
	bool isOnMirror(int v) const
	{
		return mirrorAxis >= 0 && coordinate(position[v], mirrorAxis) == 0;
	}

	/// The number of sides of the mirror plane in the whole mesh: 2 for half of a symmetric mesh.
	int sideNum() const { return mirrorAxis >= 0 ? 2 : 1; }
	/// The number of vertices of the whole mesh for a vertex at a place.
	int multiplicity(const Vec3f& place) const
	{
		return mirrorAxis >= 0 && coordinate(place, mirrorAxis) != 0 ? 2 : 1;
	}

	/// A new place for v, projected to the mirror plane if v lies on the plane.
	template <class S>
	Vec3<S> keptOnMirror(int v, Vec3<S> place) const
	{
		if (isOnMirror(v)) setCoordinate(place, mirrorAxis, S(0));
		return place;
	}

	Vec3f edgeVector(int h) const { return position[target(h)] - position[origin[h]]; }
	float edgeLength(int h) const { return length(edgeVector(h)); }

	/// The places of a face's corners.
	Corners corners(int f) const
	{
		return {position[origin[3 * f]], position[origin[3 * f + 1]], position[origin[3 * f + 2]]};
	}
	/// The unit normal times twice the area.
	Vec3f faceCross(int f) const { return corners(f).cross(); }
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
	/// A half-edge of the edge between a and b, preferably a -> b; or -1.
	int findEdge(int a, int b) const;
	/// Whether an edge joins a and b, also a border edge b -> a.
	bool areNeighbours(int a, int b) const;
	/// Number of faces at v.
	int valence(int v) const;
	/// The border half-edge that ends in border vertex v.
	int incomingBorder(int v) const;
};

/// Calls visit(h) for every half-edge from v, counter-clockwise, beginning at the border if v is a
/// border vertex. `visit` must not enlarge the mesh, here and below: arrays are looked up once, as
/// the compiler must assume that `visit` changes pointers.
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

/// Calls visit(h, a, b) for every half-edge h from v, as above. a and b are the vectors from v to
/// target(h) and apex(h). Reads each place of the ring once.
template <class Visit>
inline void forEachFaceRound(const HalfEdgeMesh& m, int v, const Visit& visit)
{
	const int first = m.outgoing[v];
	if (first < 0) return;
	const int* const   opposite = m.opposite.data();
	const int* const   origin   = m.origin.data();
	const Vec3f* const position = m.position.data();
	const Float4       p(position[v]);
	Float4             a = Float4(position[m.target(first)]) - p;
	int                h = first;
	do {
		const int    in = prevInFace(h);
		const Float4 b  = Float4(position[origin[in]]) - p;
		visit(h, a, b);
		a = b;
		h = opposite[in];
	} while (h >= 0 && h != first);
}

/// The faces round a vertex, added up.
struct RingSum {
	Vec3f normal;   ///< sum of face normals, each twice the face area long
	float area = 0; ///< twice the sum of face areas
};

inline RingSum ringSum(const HalfEdgeMesh& m, int v)
{
	Float4 normal;
	float  area = 0;
	forEachFaceRound(m, v, [&](int, const Float4& a, const Float4& b) {
		const Float4 ofFace = cross(a, b);
		normal += ofFace;
		area += length(ofFace);
	});
	return {normal.xyz(), area};
}

/// Calls visit(w) for every neighbour w of v, including the end of the last border edge.
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
		// The next target is the same vertex, but this way the visit need not wait for `next`.
		const int in   = prevInFace(h);
		const int next = opposite[in];
		if (next == first) return;
		visit(origin[in]);
		if (next < 0) return;
		h = next;
	}
}

/// Whether a test holds for any half-edge from v.
template <class Test>
bool anyOutgoing(const HalfEdgeMesh& m, int v, const Test& test)
{
	bool isAny = false;
	forEachOutgoing(m, v, [&](int h) { isAny = isAny || test(h); });
	return isAny;
}

/// Whether a test holds for any neighbour of v.
template <class Test>
bool anyNeighbour(const HalfEdgeMesh& m, int v, const Test& test)
{
	bool isAny = false;
	forEachNeighbour(m, v, [&](int w) { isAny = isAny || test(w); });
	return isAny;
}

/// The faces at the vertices, ascending.
std::vector<int> facesRound(const HalfEdgeMesh& mesh, const std::vector<int>& vertices);
/// The corners of the faces, ascending.
std::vector<int> verticesOf(const HalfEdgeMesh& mesh, const std::vector<int>& faces);
/// Adds the faces at the corners of the faces, `rings` times.
std::vector<int> widened(const HalfEdgeMesh& mesh, std::vector<int> faces, int rings);

/// A view of vertices and faces in the form of an input mesh. The mesh must stay in place.
MeshView viewOf(const HalfEdgeMesh& mesh);

} // namespace gpr

#endif
