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

/// The weighted mean of the values at the corners of the point's face; valueOf(k) is the value at
/// corner k. Skips corners without weight, as a value there may be NaN. Weights are floats, whose
/// sum is not exactly 1; and the limits keep a constant the same in spite of rounding.
template <class ValueOf>
double meanOfCorners(const BarycentricPoint& at, const ValueOf& valueOf)
{
	constexpr double infinity = std::numeric_limits<double>::infinity();
	double           sum = 0, weights = 0, least = infinity, most = -infinity;
	for (int k = 0; k < 3; ++k) {
		if (at.weight[k] == 0) continue;
		const double value = double(valueOf(k));
		sum += double(at.weight[k]) * value;
		weights += double(at.weight[k]);
		least = std::min(least, value);
		most  = std::max(most, value);
	}
	return std::min(std::max(sum / weights, least), most);
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
