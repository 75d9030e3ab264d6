// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_CARRY_OVER_H
#define VCG_EXTRAS_CORE_CARRY_OVER_H

#include "mesh_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

// How values of the caller's mesh come to points of its surface: the one rule for every host.

namespace gpr {

/// Σ weight·value over the corners of the point's face; valueOf(k) is the value at corner k.
/// Corners without weight are left out, so that a NaN there does no harm.
template <class ValueOf>
double meanOfCorners(const BarycentricPoint& at, const ValueOf& valueOf)
{
	double sum = 0;
	for (int k = 0; k < 3; ++k) {
		if (at.weight[k] != 0) sum += double(at.weight[k]) * double(valueOf(k));
	}
	return sum;
}

/// The corner with the largest weight, for values that have no mean: labels, numbers of images.
inline int nearestCorner(const BarycentricPoint& at)
{
	return int(std::max_element(at.weight, at.weight + 3) - at.weight);
}

/// A mean as the type that values are kept in: whole numbers are rounded, as a constant colour
/// would come out one darker if it were cut off, and kept within their range.
template <class T>
T meanAs(double mean)
{
	if constexpr (std::is_integral<T>::value) {
		const double least = double(std::numeric_limits<T>::lowest());
		const double most  = double(std::numeric_limits<T>::max());
		return T(std::clamp(std::floor(mean + 0.5), least, most));
	}
	else {
		return T(mean);
	}
}

} // namespace gpr

#endif
