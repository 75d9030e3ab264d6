// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_CARRY_OVER_H
#define VCG_EXTRAS_CORE_CARRY_OVER_H

#include "mesh_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

// The rule by which values of the input come to points of the surface, for every host.

namespace gpr {

/// Σ weight·value over the corners of the point's face; valueOf(k) is the value at corner k. Skips
/// corners without weight, as a value there may be NaN.
template <class ValueOf>
double meanOfCorners(const BarycentricPoint& at, const ValueOf& valueOf)
{
	double sum = 0;
	for (int k = 0; k < 3; ++k) {
		if (at.weight[k] != 0) sum += double(at.weight[k]) * double(valueOf(k));
	}
	return sum;
}

/// The corner with the largest weight, for values without a mean: labels, numbers of images.
inline int nearestCorner(const BarycentricPoint& at)
{
	return int(std::max_element(at.weight, at.weight + 3) - at.weight);
}

/// Converts a mean to the type of the values. Whole numbers are rounded and clamped to their range:
/// a constant colour would become darker by one if the fraction were cut off.
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
