// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "seam_edges.h"

#include <algorithm>

namespace gpr {

namespace {

/// The number of common vertices of the input faces f and g.
int commonCorners(const MeshView& input, int f, int g)
{
	const auto a = input.triangle(std::size_t(f)), b = input.triangle(std::size_t(g));
	return int(std::count_if(a.begin(), a.end(), [&](std::int32_t v) {
		return std::find(b.begin(), b.end(), v) != b.end();
	}));
}

} // namespace

std::vector<int> findSeamEdges(const MeshView& input, const Surface& surface, Workers& workers)
{
	const HalfEdgeMesh& m = surface.mesh;
	return workers.collectIf(std::size_t(m.halfEdgeNum()), [&](int h) {
		const int other = m.opposite[h];
		if (other < h) return false;
		const int f = surface.sourceFace[h / 3], g = surface.sourceFace[other / 3];
		return f != g && commonCorners(input, f, g) < 2;
	});
}

} // namespace gpr
