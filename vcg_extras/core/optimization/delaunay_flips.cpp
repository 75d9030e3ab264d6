// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay_flips.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <cmath>

namespace gpr {

namespace {

/// The largest number of flips set off by an edge; ends an unending exchange between two places.
constexpr int maxFlipsInARow = 200;

bool improvesAngles(const HalfEdgeMesh& m, int h)
{
	const int g = m.opposite[h];
	if (m.isCurveEdge(h)) return false;
	const Vec3f a = m.position[m.origin[h]], b = m.position[m.target(h)];
	const Vec3f c = m.position[m.apex(h)], d = m.position[m.apex(g)];
	const Vec3f ca = a - c, cb = b - c, da = a - d, db = b - d;
	const float cos1 = dot(ca, cb), cos2 = dot(da, db);
	if (cos1 >= 0 && cos2 >= 0) return false; // nearly all edges: two acute angles
	const Vec3f n1 = cross(ca, cb), n2 = cross(db, da);
	const float sin1 = length(n1), sin2 = length(n2);
	// sin(γ + δ) < 0, with a margin for nearly co-circular corners.
	const float sine = sin1 * cos2 + cos1 * sin2;
	if (sine >= -1e-4f * (sin1 * sin2 + std::abs(cos1 * cos2))) return false;

	const Vec3f m1 = cross(a - c, d - c), m2 = cross(d - c, b - c);
	const Vec3f normal = n1 + n2;
	return dot(m1, normal) > 0 && dot(m2, normal) > 0;
}

/// Flips h, and the edges that the flips make non-Delaunay.
std::int64_t settleFrom(HalfEdgeMesh& m, int h, std::vector<int>& stack)
{
	std::int64_t flips = 0;
	stack.assign(1, h);
	while (!stack.empty()) {
		const int e = stack.back();
		stack.pop_back();
		if (flips == maxFlipsInARow) break;
		if (!improvesAngles(m, e) || !canFlip(m, e)) continue;
		const int g = m.opposite[e];
		flip(m, e);
		++flips;
		const int inner = nextInFace(e);
		for (int k = 0; k < 3; ++k) {
			const int x = 3 * (e / 3) + k, y = 3 * (g / 3) + k;
			if (x != inner) stack.push_back(x);
			if (m.opposite[y] != inner) stack.push_back(y);
		}
	}
	return flips;
}

/// The edges to flip, as the smaller half-edge of each.
std::vector<int> findFlips(const HalfEdgeMesh& m, Workers& workers)
{
	return workers.collectIf(m.halfEdgeNum(),
							 [&](int h) { return m.opposite[h] > h && improvesAngles(m, h); });
}

std::int64_t flipOnce(HalfEdgeMesh& m, const std::vector<int>& candidates)
{
	std::int64_t flips = 0;
	for (int h : candidates) {
		if (!improvesAngles(m, h) || !canFlip(m, h)) continue;
		flip(m, h);
		++flips;
	}
	return flips;
}

} // namespace

std::int64_t flipToDelaunay(ResultMesh& result, Workers& workers, int maxPasses)
{
	HalfEdgeMesh&    m = result.mesh;
	std::vector<int> stack;
	std::int64_t     flips = 0;
	if (maxPasses >= untilDelaunay) {
		for (int h : findFlips(m, workers))
			flips += settleFrom(m, h, stack);
	}
	else {
		std::int64_t last = 1;
		for (int pass = 0; pass < maxPasses && last > 0; ++pass) {
			last = flipOnce(m, findFlips(m, workers));
			flips += last;
		}
	}
	result.flipNum += flips;
	return flips;
}

} // namespace gpr
