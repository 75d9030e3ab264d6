// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_LINE_TRIANGLE_H
#define VCG_EXTRAS_CORE_LINE_TRIANGLE_H

#include "vec.h"

#include <algorithm>

namespace gpr {

/// Whether the area of a triangle, in working units, is nothing but rounding; n is the cross
/// product of its edges.
inline bool isLine(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& n)
{
	constexpr float roundingHeight = 2e-7f; // over the longest edge
	const float     longest =
		std::max({squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)});
	return !(squaredLength(n) > roundingHeight * roundingHeight * longest);
}

} // namespace gpr

#endif
