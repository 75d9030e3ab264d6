// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_lines.h"

#include <vcg_extras/core/mesh/same_place.h>

#include <algorithm>

namespace gpr {

namespace {

/// Whether a corner of input face g lies at the place of vertex v. Positions are compared, not
/// numbers: the engine alone joins vertices of a triangle soup or along a seam. Both positions may
/// lie up to samePlace from the joined vertex. scale: from mesh to working units.
bool hasCornerAt(const MeshView& input, double scale, int g, int v)
{
	constexpr double farthest = 2 * double(samePlace);
	const Vec3d      p        = input.position(std::size_t(v));
	for (std::int32_t w : input.triangle(std::size_t(g))) {
		const Vec3d away = (input.position(std::size_t(w)) - p) * scale;
		if (w == v || squaredLength(away) <= farthest * farthest) return true;
	}
	return false;
}

/// Whether the input faces f and g meet in an edge marked as a line in f.
bool isLineBetween(const MeshView& input, double scale, int f, int g)
{
	for (int k = 0; k < 3; ++k) {
		const std::size_t at = 3 * std::size_t(f);
		if (!input.line[at + std::size_t(k)]) continue;
		const int a = input.vertexOf(at + std::size_t(k));
		const int b = input.vertexOf(at + std::size_t((k + 1) % 3));
		if (hasCornerAt(input, scale, g, a) && hasCornerAt(input, scale, g, b)) return true;
	}
	return false;
}

bool isGivenLine(const MeshView& input, const Surface& surface, int h)
{
	const int other = surface.mesh.opposite[h];
	if (other < 0) return false;
	const int    f = surface.sourceFace[h / 3], g = surface.sourceFace[other / 3];
	const double scale = surface.frame.scale;
	if (f == g) return false;
	if (input.region != nullptr && input.region[f] != input.region[g]) return true;
	return input.line != nullptr &&
		   (isLineBetween(input, scale, f, g) || isLineBetween(input, scale, g, f));
}

/// The number of common vertices of the input faces f and g.
int commonCorners(const MeshView& input, int f, int g)
{
	const auto a = input.triangle(std::size_t(f)), b = input.triangle(std::size_t(g));
	return int(std::count_if(a.begin(), a.end(), [&](std::int32_t v) {
		return std::find(b.begin(), b.end(), v) != b.end();
	}));
}

} // namespace

bool hasGivenLines(const MeshView& input)
{
	return input.line != nullptr || input.hasManyRegions();
}

std::int64_t markGivenLines(const MeshView& input, Workers& workers, Surface& surface)
{
	if (!hasGivenLines(input)) return 0;
	HalfEdgeMesh&      m = surface.mesh;
	Buffer<char>       crease(m.halfEdgeNum());
	const std::int64_t halves =
		workers.sumEach<std::int64_t>(crease.size(), [&](int h, std::int64_t& added) {
			const bool was = m.isCreaseEdge(h);
			crease[h]      = was || isGivenLine(input, surface, h);
			added += crease[h] && !was;
		});
	if (halves > 0) m.crease.swap(crease);
	return halves / 2;
}

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
