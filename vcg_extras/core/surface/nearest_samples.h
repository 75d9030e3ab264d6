// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_NEAREST_SAMPLES_H
#define VCG_EXTRAS_CORE_SURFACE_NEAREST_SAMPLES_H

#include "disk_flood.h"

#include <vcg_extras/core/base/workers.h>

#include <tuple>
#include <vector>

namespace gpr {

/// A vertex reached by a label, such as a sample, for a search of the nearest label of each vertex.
/// A priority queue has the nearest first.
struct Reach {
	float distance;
	int   vertex, label;

	bool operator<(const Reach& o) const
	{
		return std::tie(o.distance, o.vertex, o.label) < std::tie(distance, vertex, label);
	}
};

/// Voronoi cells of given samples of any spacing: the nearest sample of each vertex by lengths of
/// paths over edges. Sample -1 for vertices of components without a sample; a Voronoi dual has
/// these vertices one by one, like the vertices of an open cell. Cost: Dijkstra's algorithm from
/// all samples at once, serial.
Buffer<NearestField::Nearest> assignToSamples(const Surface&             surface,
											  const std::vector<Sample>& samples, Workers& workers);

} // namespace gpr

#endif
