// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_point.h"

#include <vcg_extras/core/surface/walk.h>

#include <cmath>
#include <vector>

namespace gpr {

namespace {

/// A walk is good enough if it ends this near to the goal, over the length of the walk.
constexpr float nearEnough = 0.2f;

/// The best end so far of the walks to a goal.
struct BestEnd {
	SurfacePoint at;
	float        squaredMiss = HUGE_VALF;

	/// From all faces at a vertex that is not free: from a crease, most faces lead astray.
	void tryFrom(const HalfEdgeMesh& m, const ResultMesh& result, int v, const Vec3f& goal)
	{
		const SurfacePoint& point = result.vertex[v].point;
		for (int face : isFree(result, v) ? std::vector<int>{point.face} : facesAt(m, point)) {
			SurfacePoint end{point.position, face};
			walk(m, end, goal - point.position);
			const float miss = squaredLength(end.position - goal);
			if (miss >= squaredMiss) continue;
			squaredMiss = miss;
			at          = end;
		}
	}
};

/// Sum of the surface normals below four points of the face of h: its middle, and the middles
/// between its middle and its corners. Walks from the corner origin[h] find the places.
Vec3f normalSeenFrom(const Surface& surface, const ResultMesh& result, int h)
{
	const HalfEdgeMesh& r      = result.mesh;
	const Vec3f         middle = r.faceCentre(h / 3);
	Vec3f               sum;
	for (int k = -1; k < 3; ++k) {
		const Vec3f other = k < 0 ? middle : r.position[r.origin[3 * (h / 3) + k]];
		BestEnd     best;
		best.tryFrom(surface.mesh, result, r.origin[h], (middle + other) * 0.5f);
		if (best.at.face >= 0) sum += surface.mesh.faceNormal(best.at.face);
	}
	return sum;
}

} // namespace

SurfacePoint pointOfFace(const Surface& surface, const ResultMesh& result, int f)
{
	const HalfEdgeMesh& r      = result.mesh;
	const Vec3f         middle = r.faceCentre(f);

	BestEnd best;
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		const int   v       = r.origin[h];
		const float wayLong = length(middle - result.vertex[v].point.position);
		best.tryFrom(surface.mesh, result, v, middle);
		if (best.squaredMiss <= nearEnough * nearEnough * wayLong * wayLong) break;
	}
	return best.at.face >= 0 ? best.at : result.vertex[r.origin[3 * f]].point;
}

bool isInverted(const Surface& surface, const ResultMesh& result, int f)
{
	const Vec3f normal = result.mesh.faceCross(f);
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		if (dot(normalSeenFrom(surface, result, h), normal) >= 0) return false;
	}
	return true;
}

} // namespace gpr
