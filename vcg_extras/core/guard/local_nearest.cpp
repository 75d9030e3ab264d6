// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_nearest.h"

#include <vcg_extras/core/base/triangle.h>

#include <cmath>

namespace gpr {

namespace {

/// The nearest point so far.
struct Nearest {
	Vec3f        facing;
	SurfacePoint at;
	float        squared = HUGE_VALF;

	bool tryRound(const HalfEdgeMesh& m, int v, const Vec3f& p)
	{
		const float before = squared;
		forEachOutgoing(m, v, [&](int h) {
			if (dot(m.faceCross(h / 3), facing) < 0) return;
			const int*  c = &m.origin[3 * (h / 3)];
			const Vec3f q =
				nearestOnTriangle(p, m.position[c[0]], m.position[c[1]], m.position[c[2]]);
			const float here = squaredLength(p - q);
			if (!(here < squared)) return;
			squared = here;
			at      = {q, h / 3};
		});
		return squared < before;
	}
};

} // namespace

SurfacePoint nearestByDescent(const HalfEdgeMesh& m, int from, const Vec3f& p, const Vec3f& facing)
{
	Nearest nearest;
	nearest.facing = facing;
	bool isFarther = nearest.tryRound(m, from, p);
	while (isFarther) {
		const int face = nearest.at.face;
		isFarther      = false;
		for (int h = 3 * face; h < 3 * face + 3; ++h)
			isFarther = nearest.tryRound(m, m.origin[h], p) || isFarther;
	}
	return nearest.at;
}

} // namespace gpr
