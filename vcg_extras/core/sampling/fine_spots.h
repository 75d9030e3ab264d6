// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_FINE_SPOTS_H
#define VCG_EXTRAS_CORE_SAMPLING_FINE_SPOTS_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <cstddef>
#include <vector>

namespace gpr {

/// A place at which triangles must be smaller, because a result was too far from the input there.
struct FineSpot {
	Vec3d  position;   ///< in the frame of the input mesh
	double reach  = 0; ///< radius of the place, mesh units
	double factor = 1; ///< multiplies the size there, in (0, 1]
};

/// Spots of several trials. The spots of a trial correct the sizes of that trial, so factors are
/// multiplied over the trials. Among the spots of one trial the smallest factor counts.
using FineSpots = std::vector<std::vector<FineSpot>>;

/// What the spots of a trial depend on.
struct TrialOfSpots {
	std::size_t before = 0; ///< trials before this trial
	double      goal   = 0; ///< the largest distance allowed, working units
	double      edge   = 0; ///< ideal edge, working units
};

/// Adds a spot for each place that is farther from the other surface than the goal. Later trials
/// make triangles smaller, and in wider places.
void addSpots(const std::vector<FarPlace>& places, const TrialOfSpots& trial, const Frame& frame,
			  std::vector<FineSpot>& spots);

/// The factor of the size at every vertex of a surface, not graded; 1 without a spot, and at least
/// leastFactor. Cost: linear, parallel; some memory for each spot.
Buffer<float> factorsOf(const FineSpots& spots, const Surface& surface, Workers& workers);

/// The smallest factor of a size.
constexpr float leastFactor = 0.2f;

} // namespace gpr

#endif
