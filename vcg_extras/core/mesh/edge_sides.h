// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_EDGE_SIDES_H
#define VCG_EXTRAS_CORE_MESH_EDGE_SIDES_H

#include "half_edge_mesh.h"
#include "indexed_mesh.h"

#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/mesh_view.h>

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace gpr {

/// A half-edge as a side of its edge, which is named by two vertices or two places.
struct EdgeSide {
	int low, high; ///< the edge's ends
	int halfEdge;

	bool isOfSameEdge(const EdgeSide& o) const { return low == o.low && high == o.high; }
	bool operator<(const EdgeSide& o) const
	{
		return std::tie(low, high, halfEdge) < std::tie(o.low, o.high, o.halfEdge);
	}
};

inline EdgeSide edgeSide(int a, int b, int halfEdge)
{
	return {std::min(a, b), std::max(a, b), halfEdge};
}

/// The side h of an edge of a mesh without adjacency.
inline EdgeSide edgeSide(const IndexedMesh& mesh, int h)
{
	return edgeSide(mesh.triangle[h], mesh.triangle[nextInFace(h)], h);
}

/// The side of an edge of a mesh that begins at a corner.
inline EdgeSide edgeSide(const MeshView& mesh, std::size_t corner)
{
	return edgeSide(mesh.vertexOf(corner), mesh.vertexOf(corner % 3 == 2 ? corner - 2 : corner + 1),
					int(corner));
}

/// The sides of all edges of a mesh, sorted; also of edges with a repeated vertex. Cost: linear,
/// parallel.
inline Buffer<EdgeSide> sortedSides(const MeshView& mesh, Workers& workers)
{
	return sortedByBuckets<EdgeSide>(
		3 * mesh.faceNum, mesh.vertexNum, [&](std::size_t c) { return edgeSide(mesh, c); },
		[](const EdgeSide& s) { return s.low; }, workers);
}

/// Calls visit(begin, end) for each run of sides of the same edge. Needs sorted sides.
template <class Sides, class Visit>
void forEachEdge(const Sides& sides, const Visit& visit)
{
	for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
		for (end = i + 1; end < sides.size() && sides[end].isOfSameEdge(sides[i]);)
			++end;
		visit(i, end);
	}
}

/// Fills opposite and outgoing of a mesh with room for both; the mesh is given by its origins, and
/// outgoing is -1 for vertices in no face. isPair(sides, num): whether the sides of an edge are the
/// two halves of an inner edge; else the sides are border. Cost: linear, parallel in part.
template <class IsPair>
void linkFaces(HalfEdgeMesh& m, Workers& workers, const IsPair& isPair)
{
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		m.opposite[h]           = -1;
		m.outgoing[m.origin[h]] = h;
	}
	const Buffer<EdgeSide> sides = sortedByBuckets<EdgeSide>(
		std::size_t(m.halfEdgeNum()), std::size_t(m.vertexNum),
		[&](int h) { return edgeSide(m.origin[h], m.target(h), h); },
		[](const EdgeSide& s) { return s.low; }, workers);
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		if (!isPair(&sides[begin], end - begin)) return;
		m.opposite[sides[begin].halfEdge]     = sides[begin + 1].halfEdge;
		m.opposite[sides[begin + 1].halfEdge] = sides[begin].halfEdge;
	});
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (m.opposite[h] < 0) m.outgoing[m.origin[h]] = h;
	}
}

} // namespace gpr

#endif
