// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_ANGLE_H
#define VCG_EXTRAS_CORE_BASE_ANGLE_H

#include "portable_math.h"

#include <vcg_extras/core/vec.h>

namespace gpr {

/// The angle between two vectors, radians; 0 if a vector has length 0.
inline float angleBetween(const Vec3f& a, const Vec3f& b)
{
	return portable::angle(length(cross(a, b)), dot(a, b));
}

} // namespace gpr

#endif
