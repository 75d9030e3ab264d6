// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_MADE_VERTEX_H
#define VCG_EXTRAS_CORE_GUARD_MADE_VERTEX_H

#include "guarded_decimation.h"

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// The record of vertex v of a mesh made by guarded collapses, on no curve. The point is the
/// nearest in a search from vertex surfaceVertex of the surface. A fixed vertex is pinned. Cost: as
/// nearestByDescent.
ResultVertex madeVertex(const Surface& surface, int surfaceVertex, const GuardedMesh& made, int v);

} // namespace gpr

#endif
