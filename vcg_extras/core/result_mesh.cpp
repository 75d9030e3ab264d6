// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_mesh.h"

#include "mesh_edit.h"

#include <cmath>

namespace gpr {

namespace {

/// Angle between two vectors.
float angleBetween(const Vec3f& u, const Vec3f& v)
{
	return std::atan2(length(cross(u, v)), dot(u, v));
}

} // namespace

void compactResult(ResultMesh& result)
{
	std::vector<int> newIndex;
	compact(result.mesh, newIndex);
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

float triangleShape(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	const float edges = squaredLength(b - a) + squaredLength(c - b) + squaredLength(a - c);
	return 3.4641016f * length(cross(b - a, c - a)) / (edges + 1e-30f);
}

} // namespace gpr
