// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_point.h"

#include <algorithm>

namespace gpr {

SurfacePoint surfacePoint(const MeshView& input, const Surface& surface, const Anchor& anchor)
{
	SurfacePoint s;
	const Vec3d  p = surface.frame.toCaller(anchor.position);
	s.face         = surface.sourceFace[anchor.face];
	const auto   t = input.triangle(std::size_t(s.face));
	const Vec3d  a = input.position(t[0]), b = input.position(t[1]), c = input.position(t[2]);
	const Vec3d  n       = cross(b - a, c - a);
	const double squared = squaredLength(n);
	double       wb = 0, wc = 0;
	if (squared > 0) {
		wb = dot(cross(p - a, c - a), n) / squared;
		wc = dot(cross(b - a, p - a), n) / squared;
	}
	wb          = std::min(1.0, std::max(0.0, wb));
	wc          = std::min(1.0 - wb, std::max(0.0, wc));
	s.weight[0] = float(1 - wb - wc);
	s.weight[1] = float(wb);
	s.weight[2] = float(wc);
	return s;
}

} // namespace gpr
