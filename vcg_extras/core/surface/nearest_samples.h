// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_NEAREST_SAMPLES_H
#define VCG_EXTRAS_CORE_SURFACE_NEAREST_SAMPLES_H

#include "disk_flood.h"

#include <vcg_extras/core/base/workers.h>

#include <vector>

namespace gpr {

/// Voronoi cells of given samples of any spacing: the nearest sample of each vertex by lengths of
/// paths over edges. Sample -1 for vertices of components without a sample; a Voronoi dual has
/// these vertices one by one, like the vertices of an open cell. Cost: Dijkstra's algorithm from
/// all samples at once, serial.
Buffer<NearestField::Nearest> assignToSamples(const Surface&             surface,
											  const std::vector<Sample>& samples, Workers& workers);

} // namespace gpr

#endif
