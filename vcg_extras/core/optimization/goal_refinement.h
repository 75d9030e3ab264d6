// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_GOAL_REFINEMENT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_GOAL_REFINEMENT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

enum class GoalOutcome {
	Open,      ///< some points are beyond the goal, or there was no refinement yet
	Kept,      ///< no point is beyond the goal
	OutOfReach ///< far more points than vertices, or many points that no new vertex brings near
};

struct GoalRefinement {
	GoalOutcome      outcome = GoalOutcome::Open;
	std::vector<int> farFaces; ///< if open: at single places that are left; ascending
};

/// Makes triangles smaller at the places with a distance between result and surface above `goal`,
/// in rounds. goal: working units. Cost: placesBeyond in both directions, then in each round
/// refineAt and placesBeyond near the changes.
GoalRefinement refineToGoal(const Surface& surface, const BoundaryCurves& curves, double goal,
							ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
