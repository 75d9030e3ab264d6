// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_GOAL_REFINEMENT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_GOAL_REFINEMENT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Makes triangles smaller at the places with a distance between result and surface above `goal`,
/// in rounds. Stops at too many places, because all triangles are too large then. Returns whether
/// no point is beyond the goal any more. goal: working units. Cost: per round, placesBeyond in both
/// directions, and refineAt.
bool refineToGoal(const Surface& surface, const BoundaryCurves& curves, double goal,
				  ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
