// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_WORST_TRIANGLES_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_WORST_TRIANGLES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Stage 11: raises the smallest angles. Flat inner vertices of triangles with an angle below
/// `angleDeg` search for a better place on the surface round them, accepted if the worst angle of
/// the ring grows and no face turns; then edges are flipped where that raises the smaller angle of
/// the pair. Some rounds, until none is left or none improves. Cost: a pass over the faces a round,
/// and the few vertices concerned.
void raiseWorstAngles(const Surface& surface, float angleDeg, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
