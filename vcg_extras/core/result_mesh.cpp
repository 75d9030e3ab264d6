// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_mesh.h"

#include "mesh_edit.h"

#include <algorithm>
#include <cmath>

namespace gpr {

ResultMesh copyResult(const ResultMesh& result, Workers& workers)
{
	ResultMesh copy;
	copy.mesh          = copyMesh(result.mesh, workers);
	copy.vertex        = result.vertex;
	copy.keepsBorder   = result.keepsBorder;
	copy.idealEdge     = result.idealEdge;
	copy.flipNum       = result.flipNum;
	copy.splitNum      = result.splitNum;
	copy.collapseNum   = result.collapseNum;
	copy.byCollapseNum = result.byCollapseNum;
	copy.leftoverNum   = result.leftoverNum;
	return copy;
}

void compactResult(ResultMesh& result, Workers& workers)
{
	Buffer<int> newIndex;
	compact(result.mesh, workers, newIndex);
	if (result.vertex.size() == std::size_t(result.mesh.vertexNum)) return;
	for (std::size_t v = 0; v < newIndex.size(); ++v) {
		if (newIndex[v] >= 0) result.vertex[newIndex[v]] = result.vertex[v];
	}
	result.vertex.resize(result.mesh.vertexNum);
}

float smallestAngle(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	// The smallest angle lies opposite the shortest edge.
	const float ab = squaredLength(b - a), bc = squaredLength(c - b), ca = squaredLength(a - c);
	if (ab <= bc && ab <= ca) return angleBetween(a - c, b - c);
	if (bc <= ca) return angleBetween(b - a, c - a);
	return angleBetween(a - b, c - b);
}

float smallestAngle(const HalfEdgeMesh& m, int face)
{
	const int* corner = &m.origin[3 * face];
	return smallestAngle(m.position[corner[0]], m.position[corner[1]], m.position[corner[2]]);
}

float smallestAngleAround(const HalfEdgeMesh& m, int v, const Vec3f& p, float turnCosine)
{
	const Vec3f here  = m.position[v];
	float       worst = 4;
	forEachOutgoing(m, v, [&](int h) {
		const Vec3f a = m.position[m.target(h)], b = m.position[m.apex(h)];
		const Vec3f now = cross(a - here, b - here), then = cross(a - p, b - p);
		const bool  turns = dot(now, then) <= turnCosine * length(now) * length(then);
		worst             = std::min(worst, turns ? -1.0f : smallestAngle(p, a, b));
	});
	return worst;
}

float triangleShape(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	const float edges = squaredLength(b - a) + squaredLength(c - b) + squaredLength(a - c);
	return 3.4641016f * length(cross(b - a, c - a)) / (edges + 1e-30f);
}

float farthestFromAnchor(const ResultMesh& r)
{
	float farthest = 0;
	for (int v = 0; v < r.mesh.vertexNum; ++v) {
		const Vec3f off = r.mesh.position[v] - r.vertex[v].anchor.position;
		farthest        = std::max(farthest, squaredLength(off));
	}
	return std::sqrt(farthest);
}

} // namespace gpr
