// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "poor_faces.h"

#include "mesh_edit.h"
#include "result_mesh.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Shortest over longest edge of a triangle with the smallest angle α are sin α / sin γ, γ being
/// the largest angle, between 90° - α/2 and 180° - 2α: at most the larger of these. A little more,
/// for rounding.
float largestEdgeRatio(float angle)
{
	return 1.001f * std::max(0.5f / std::cos(angle), 2 * std::sin(0.5f * angle));
}

} // namespace

std::vector<int> findPoorFaces(const HalfEdgeMesh& m, float angle, Workers& workers)
{
	const float ratio   = largestEdgeRatio(angle);
	const float squared = ratio * ratio;
	const auto  isPoor  = [&](int f) {
        const Vec3f a = m.position[m.origin[3 * f]], b = m.position[m.origin[3 * f + 1]];
        const Vec3f c  = m.position[m.origin[3 * f + 2]];
        const float ab = squaredLength(b - a), bc = squaredLength(c - b), ca = squaredLength(a - c);
        const float shortest = std::min({ab, bc, ca}), longest = std::max({ab, bc, ca});
        return !(shortest > squared * longest) && smallestAngle(a, b, c) < angle;
	};
	return workers.collect<int>(m.faceNum, [&](std::size_t begin, std::size_t end, auto& out) {
		for (int f = int(begin); f < int(end); ++f) {
			if (!isDeadFace(m, f) && isPoor(f)) out.push_back(f);
		}
	});
}

} // namespace gpr
