// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_point.h"

#include <vcg_extras/core/surface/walk.h>

#include <cmath>
#include <vector>

namespace gpr {

namespace {

/// A way that ends so near to the middle, in the way's own length, is the right one.
constexpr float nearEnough = 0.2f;

/// The best end so far of ways to a point.
struct BestEnd {
	SurfacePoint at;
	float        squaredMiss = HUGE_VALF;

	void tryFrom(const HalfEdgeMesh& m, SurfacePoint from, const Vec3f& goal)
	{
		walk(m, from, goal - from.position);
		const float miss = squaredLength(from.position - goal);
		if (miss >= squaredMiss) return;
		squaredMiss = miss;
		at          = from;
	}
};

/// The faces from which a way may begin: on a crease all but one lead astray.
std::vector<int> facesToBeginIn(const HalfEdgeMesh& m, const ResultMesh& result, int v)
{
	const SurfacePoint& point = result.vertex[v].point;
	return isFree(result, v) ? std::vector<int>{point.face} : facesAt(m, point);
}

} // namespace

SurfacePoint pointOfFace(const Surface& surface, const ResultMesh& result, int f)
{
	const HalfEdgeMesh& r      = result.mesh;
	const Vec3f         middle = r.faceCentre(f);

	BestEnd best;
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		const int          v       = r.origin[h];
		const SurfacePoint corner  = result.vertex[v].point;
		const float        wayLong = length(middle - corner.position);
		for (int face : facesToBeginIn(surface.mesh, result, v))
			best.tryFrom(surface.mesh, {corner.position, face}, middle);
		if (best.squaredMiss <= nearEnough * nearEnough * wayLong * wayLong) break;
	}
	return best.at.face >= 0 ? best.at : result.vertex[r.origin[3 * f]].point;
}

} // namespace gpr
