// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_ORIENTATION_H
#define VCG_EXTRAS_CORE_BASE_ORIENTATION_H

#include <vcg_extras/core/vec.h>

namespace gpr {

/// The side of the plane a b c on which point d lies, exactly: 1 if a, b, c turn counter-clockwise
/// seen from d, -1 on the other side, 0 in the plane. Exact arithmetic is used only if an error
/// bound demands it. Coordinates must be 0 or between 1e-30 and 1e30 in size, as working
/// coordinates are.
int orientation(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d);

/// The point without coordinate `axis` (0, 1 or 2).
inline Vec2f dropAxis(const Vec3f& p, int axis)
{
	if (axis == 0) return {p.y, p.z};
	return axis == 1 ? Vec2f{p.z, p.x} : Vec2f{p.x, p.y};
}

/// 1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if collinear; exactly.
int orientation(const Vec2f& a, const Vec2f& b, const Vec2f& c);

} // namespace gpr

#endif
