// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_GIVEN_SAMPLES_H
#define VCG_EXTRAS_CORE_SAMPLING_GIVEN_SAMPLES_H

#include "front_sampling.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Samples of any origin in the place of our own.
struct GivenSamples {
	Sampling          sampling;
	std::vector<char> isMoved;      ///< per sample: it was off the surface
	std::int64_t      movedNum = 0; ///< of these
	float             farthest = 0; ///< from a sample as given to the surface, working units
};

/// Puts points, in the caller's frame, on the surface, each to the nearest place. Throws Failure
/// where one is not finite. Cost: O(log F) a point, serial, and the building of a tree.
GivenSamples takeOverSamples(const Surface& surface, const std::vector<Vec3d>& points,
							 Workers& workers);

} // namespace gpr

#endif
