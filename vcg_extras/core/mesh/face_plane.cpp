// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_plane.h"

namespace gpr {

Foot FacePlane::footOnEdges(const Vec3f& p) const
{
	const float ab = shareOnSegment(p, corner_.a, corner_.b);
	const float bc = shareOnSegment(p, corner_.b, corner_.c);
	const float ca = shareOnSegment(p, corner_.c, corner_.a);

	const Foot onEdge[3] = {{{1 - ab, ab, 0}}, {{0, 1 - bc, bc}}, {{ca, 0, 1 - ca}}};
	Foot       best      = onEdge[0];
	for (const Foot& f : onEdge) {
		if (squaredDistance(p, f) < squaredDistance(p, best)) best = f;
	}
	return best;
}

} // namespace gpr
