// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_SURFACE_REFINEMENT_H
#define VCG_EXTRAS_CORE_INPUT_SURFACE_REFINEMENT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Splits the long faces of a surface that is connected, as splitLongEdges does: `longFaces` are
/// all that findLongFaces finds. New vertices and faces are put where they belong in the order in
/// space, which the sampling relies on; the grid of that order stays. Feature lines must not be
/// marked yet. Returns the number of edges split; throws Failure{OutOfMemory} where the surface
/// would have more than maxFaces faces. Cost: a parallel copy of the surface, and a serial pass
/// over the parts.
std::int64_t refineSurface(const std::vector<int>& longFaces, float maxLength,
						   std::int64_t maxFaces, Surface& surface, Workers& workers);

} // namespace gpr

#endif
