// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "false_edges.h"

#include <vcg_extras/core/features/edge_middle.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/junctions.h>

#include <utility>
#include <vector>

namespace gpr {

namespace {

/// The middle of an edge on the surface, or on the edge itself if no walk finds the middle.
ResultVertex middleOf(const Surface& surface, const ResultMesh& result, int h)
{
	const int    a = result.mesh.origin[h], b = result.mesh.target(h);
	ResultVertex middle;
	if (findMiddle(surface, result, a, b, middle)) return middle;
	const ResultVertex& end = result.vertex[a];
	middle                  = ResultVertex();
	middle.normal           = end.normal;
	middle.point = {(result.mesh.position[a] + result.mesh.position[b]) * 0.5f, end.point.face};
	return middle;
}

} // namespace

int splitFalseEdges(const Surface& surface, ResultMesh& result, Workers& workers)
{
	HalfEdgeMesh&                    m = result.mesh;
	std::vector<std::pair<int, int>> edges; // by the ends, because splits renumber half-edges
	for (int h : Junctions(m, surface.meetings, workers).falseEdges(workers))
		edges.push_back({m.origin[h], m.target(h)});
	const int num = int(edges.size());
	if (num > 0) reserve(m, m.vertexNum + num, m.faceNum + 2 * num);
	for (const auto& [a, b] : edges) {
		const int h = m.findHalfEdge(a, b);
		result.vertex.push_back(middleOf(surface, result, h));
		result.vertex.back().isCorner = true; // keeps the vertex from being merged again
		m.position[m.vertexNum]       = result.vertex.back().point.position;
		splitEdge(m, h, m.vertexNum++);
		++result.splitNum;
	}
	return num;
}

} // namespace gpr
