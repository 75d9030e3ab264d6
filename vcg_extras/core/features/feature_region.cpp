// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_region.h"

#include <vcg_extras/core/surface/barycentric_point.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>

namespace gpr {

namespace {

/// Rounding puts less on the corners beside a vertex of the caller's.
constexpr float weightThatCounts = 1e-4f;

bool isBetweenMarks(const MeshView& input, const std::uint8_t* marks, const BarycentricPoint& at)
{
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
		workers.sum<std::int64_t>(isInside.size(), [&](std::size_t begin, std::size_t end) {
			std::int64_t found = 0;
			for (std::size_t v = begin; v < end; ++v) {
				isInside[v] = surface.mesh.outgoing[v] >= 0 &&
							  isBetweenMarks(
								  input, marks,
								  barycentricPoint(input, surface, pointOfVertex(surface, int(v))));
				found += isInside[v];
			}
			return found;
		});
	return num > 0 ? std::move(isInside) : Buffer<char>();
}

std::vector<int> callersVertices(const MeshView& input, const Buffer<char>& region,
								 const Surface& surface, Workers& workers)
{
	return workers.collect<int>(
		region.size(), [&](std::size_t begin, std::size_t end, std::vector<int>& part) {
			for (std::size_t v = begin; v < end; ++v) {
				if (!region[v]) continue;
				const BarycentricPoint at =
					barycentricPoint(input, surface, pointOfVertex(surface, int(v)));
				const float most = *std::max_element(at.weight, at.weight + 3);
				if (most > 1 - weightThatCounts) part.push_back(int(v));
			}
		});
}

} // namespace gpr
