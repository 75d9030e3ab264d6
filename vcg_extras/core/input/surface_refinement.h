// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_SURFACE_REFINEMENT_H
#define VCG_EXTRAS_CORE_INPUT_SURFACE_REFINEMENT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Splits the long faces of a connected surface as splitLongEdges does. longFaces: all faces found
/// by findLongFaces. New vertices and faces take their places in the spatial order, which the
/// sampling needs; the grid of the order stays. Feature lines must not be marked yet. Returns the
/// number of split edges; throws Failure{OutOfMemory} if the surface would get more than maxFaces
/// faces. Cost: a parallel copy of the surface, and a serial pass over the parts.
std::int64_t refineSurface(const std::vector<int>& longFaces, float maxLength,
						   std::int64_t maxFaces, Surface& surface, Workers& workers);

} // namespace gpr

#endif
