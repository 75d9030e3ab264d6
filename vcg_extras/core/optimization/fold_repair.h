// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_FOLD_REPAIR_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_FOLD_REPAIR_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Where the surface is thinner than the triangles (fingers, lips, thin plates) removal can leave
/// faces that look against the surface. Each such face, and its neighbours, is mended by the flip,
/// move or collapse that helps most, one after the other, until none is left or none helps. Border
/// vertices move along their curve only, and stay between their neighbours. mayCollapse: whether
/// vertices may go, which only the exact count makes good again. Returns the number of faces that
/// still look the wrong way, or nearly. Cost: a pass over the faces a round, and the few faces
/// concerned.
int mendFolds(const Surface& surface, const BoundaryCurves& boundary, bool mayCollapse,
			  ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
