// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_FINE_SPOTS_H
#define VCG_EXTRAS_CORE_SAMPLING_FINE_SPOTS_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <vector>

namespace gpr {

/// A place where triangles are to be smaller, because a result was too far from the input there.
struct FineSpot {
	Vec3d  position;   ///< in the caller's frame
	double reach  = 0; ///< mesh units: so far around
	double factor = 1; ///< of the size there, in (0, 1]
};

/// Spots of several trials. Those of one trial say what its sizes lacked, so they are multiplied
/// over the trials; of one trial's spots the smallest counts.
using FineSpots = std::vector<std::vector<FineSpot>>;

/// The factor of the size at every vertex of a surface, not graded; 1 where there is no spot, and
/// not below leastFactor. Cost: linear, parallel; some memory for each spot.
Buffer<float> factorsOf(const FineSpots& spots, const Surface& surface, Workers& workers);

/// The least factor of a size.
constexpr float leastFactor = 0.2f;

} // namespace gpr

#endif
