// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_lines.h"

namespace gpr {

namespace {

/// Whether a corner of the caller's face g lies where vertex v does. Positions, not numbers: the
/// vertices of a triangle soup are welded by the engine only.
bool hasCornerAt(const MeshView& input, int g, int v)
{
	const Vec3d p = input.position(std::size_t(v));
	for (int k = 0; k < 3; ++k) {
		const int w = input.vertexOf(3 * std::size_t(g) + std::size_t(k));
		if (w == v || squaredLength(input.position(std::size_t(w)) - p) == 0) return true;
	}
	return false;
}

/// Whether the caller's faces f and g meet in an edge that f has as a line.
bool isLineBetween(const MeshView& input, int f, int g)
{
	for (int k = 0; k < 3; ++k) {
		const std::size_t at = 3 * std::size_t(f);
		if (!input.line[at + std::size_t(k)]) continue;
		const int a = input.vertexOf(at + std::size_t(k));
		const int b = input.vertexOf(at + std::size_t((k + 1) % 3));
		if (hasCornerAt(input, g, a) && hasCornerAt(input, g, b)) return true;
	}
	return false;
}

bool isGivenLine(const MeshView& input, const Surface& surface, int h)
{
	const int other = surface.mesh.opposite[h];
	if (other < 0) return false;
	const int f = surface.sourceFace[h / 3], g = surface.sourceFace[other / 3];
	return f != g && (isLineBetween(input, f, g) || isLineBetween(input, g, f));
}

} // namespace

std::int64_t markGivenLines(const MeshView& input, Workers& workers, Surface& surface)
{
	if (input.line == nullptr) return 0;
	HalfEdgeMesh& m = surface.mesh;
	Buffer<char>  crease(m.halfEdgeNum());
	const auto    mark = [&](std::size_t begin, std::size_t end) {
        std::int64_t added = 0;
        for (std::size_t h = begin; h < end; ++h) {
            const bool was = m.isCreaseEdge(int(h));
            crease[h]      = was || isGivenLine(input, surface, int(h));
            added += crease[h] && !was;
        }
        return added;
	};
	const std::int64_t halves = workers.sum<std::int64_t>(crease.size(), mark);
	if (halves > 0) m.crease.swap(crease);
	return halves / 2;
}

} // namespace gpr
