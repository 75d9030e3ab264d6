// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_region.h"

#include <vcg_extras/core/mesh/same_place.h>
#include <vcg_extras/core/surface/barycentric_point.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>

namespace gpr {

namespace {

/// Rounding gives less weight to the corner opposite to a split edge.
constexpr float weightThatCounts = 1e-4f;

/// The input vertex at the place of vertex v; -1 if v was made by a split. Decided by place, not by
/// weights: rounding moves no vertex far, but on small triangles it puts much weight on the wrong
/// corners.
std::int32_t callersVertexAt(const MeshView& input, const Surface& surface, int v)
{
	const int    face    = surface.sourceFace[pointOfVertex(surface, v).face];
	std::int32_t nearest = -1;
	float        least   = samePlace * samePlace;
	for (std::int32_t c : input.triangle(std::size_t(face))) {
		const Vec3f place    = surface.frame.toWorking(input.position(std::size_t(c)));
		const float distance = squaredLength(place - surface.mesh.position[v]);
		if (distance > least) continue;
		least   = distance;
		nearest = c;
	}
	return nearest;
}

bool isBetweenMarks(const MeshView& input, const std::uint8_t* marks, const Surface& surface, int v)
{
	const std::int32_t own = callersVertexAt(input, surface, v);
	if (own >= 0) return marks[own] != 0;
	const BarycentricPoint at = barycentricPoint(input, surface, pointOfVertex(surface, v));
	for (int k = 0; k < 3; ++k) {
		const std::int32_t corner = input.vertexOf(3 * std::size_t(at.face) + std::size_t(k));
		if (at.weight[k] > weightThatCounts && marks[corner] == 0) return false;
	}
	return true;
}

} // namespace

Buffer<char> regionVertices(const MeshView& input, const std::uint8_t* marks,
							const Surface& surface, Workers& workers)
{
	if (marks == nullptr) return Buffer<char>();
	Buffer<char>       isInside(surface.mesh.vertexNum);
	const std::int64_t num =
		workers.sumEach<std::int64_t>(isInside.size(), [&](int v, std::int64_t& found) {
			isInside[v] = surface.mesh.outgoing[v] >= 0 && isBetweenMarks(input, marks, surface, v);
			found += isInside[v];
		});
	return num > 0 ? std::move(isInside) : Buffer<char>();
}

std::vector<int> callersVertices(const MeshView& input, const Buffer<char>& region,
								 const Surface& surface, Workers& workers)
{
	return workers.collectIf(
		region.size(), [&](int v) { return region[v] && callersVertexAt(input, surface, v) >= 0; });
}

std::vector<int> borderVertices(const MeshView& input, const Surface& surface, Workers& workers)
{
	const HalfEdgeMesh& m = surface.mesh;
	return workers.collectIf(m.vertexNum, [&](int v) {
		if (m.outgoing[v] < 0 || !m.isBorderVertex(v)) return false;
		const std::int32_t own = callersVertexAt(input, surface, v);
		return own >= 0 && (input.keptBorder == nullptr || input.keptBorder[own] != 0);
	});
}

std::vector<int> unionOf(const std::vector<int>& a, const std::vector<int>& b)
{
	std::vector<int> all;
	std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
	return all;
}

} // namespace gpr
