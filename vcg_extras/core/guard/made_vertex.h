// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_MADE_VERTEX_H
#define VCG_EXTRAS_CORE_GUARD_MADE_VERTEX_H

#include "guarded_decimation.h"

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// What a result tells of vertex v of a mesh that guarded collapses have made: the point of the
/// surface next to it, downhill from a vertex of the surface (nearestByDescent), and whether it
/// stays. Cost: that of nearestByDescent.
ResultVertex madeVertex(const Surface& surface, int surfaceVertex, const GuardedMesh& made, int v);

} // namespace gpr

#endif
