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

/// Samples from the user in place of a sampling.
struct GivenSamples {
	Sampling          sampling;
	std::vector<char> isMoved;      ///< per sample: was off the surface
	std::int64_t      movedNum = 0; ///< number of moved samples
	float farthest = 0; ///< largest distance of a given point from the surface, working units
};

/// Moves points, in the frame of the input mesh, to the nearest place of the surface. Throws
/// Failure if a point is not finite. Cost: O(log F) a point, serial, and the building of a tree.
GivenSamples takeOverSamples(const Surface& surface, const std::vector<Vec3d>& points,
							 Workers& workers);

} // namespace gpr

#endif
