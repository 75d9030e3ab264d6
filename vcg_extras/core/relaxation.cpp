// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "relaxation.h"

#include "move_guard.h"
#include "sectors.h"
#include "sizing.h"
#include "walk.h"

namespace gpr {

namespace {

/// Weight of area where the triangles are to be of this size. Lloyd's theory asks for the fourth
/// power of 1/size for the density of the area; for barycentres of rings, whose faces are small
/// already where they are to be small, the third power keeps the grading (docs/algorithm.md).
float densityOfSize(float size)
{
	return 1 / (size * size * size);
}

/// Per vertex of the result; empty where the triangles are to be of one size.
Buffer<float> findDensities(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	Buffer<float> density = sizesOf(surface, result, workers);
	for (float& d : density)
		d = densityOfSize(d);
	return density;
}

/// The vertex after a walk.
ResultVertex walked(const Surface& surface, ResultVertex vertex, const Vec3f& step)
{
	walk(surface.mesh, vertex.anchor, step);
	vertex.normal = surface.mesh.faceNormal(vertex.anchor.face);
	return vertex;
}

} // namespace

Vec3f wayToBarycentre(const HalfEdgeMesh& m, int v, const Buffer<float>& density)
{
	const Vec3f p = m.position[v];
	Vec3f       sum;
	float       weight = 0;
	forEachOutgoing(m, v, [&](int h) {
		const Vec3f a = m.position[m.target(h)] - p, b = m.position[m.apex(h)] - p;
		float       area = length(cross(a, b));
		if (!density.empty()) area *= density[v] + density[m.target(h)] + density[m.apex(h)];
		sum += (a + b) * (area / 3);
		weight += area;
	});
	return weight > 0 ? sum * (1 / weight) : Vec3f();
}

Buffer<char> findFlatVertices(const ResultMesh& result, Workers& workers)
{
	Buffer<char> flat(result.mesh.vertexNum);
	workers.forRange(flat.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v)
			flat[v] = isFlat(result.mesh, int(v));
	});
	return flat;
}

void relaxOnce(const Surface& surface, ResultMesh& result, Workers& workers)
{
	const HalfEdgeMesh& m       = result.mesh;
	const Buffer<char>  flat    = findFlatVertices(result, workers);
	const Buffer<float> density = findDensities(surface, result, workers);
	MoveGuard           guard(result, workers);
	workers.forRange(m.vertexNum, [&](std::size_t begin, std::size_t end) {
		for (int v = int(begin); v < int(end); ++v) {
			if (!flat[v] || !isFree(result, v)) continue;
			const Vec3f step = tangential(wayToBarycentre(m, v, density), result.vertex[v].normal);
			if (squaredLength(step) > 0) guard.propose(v, walked(surface, result.vertex[v], step));
		}
	});
	guard.move();
}

} // namespace gpr
