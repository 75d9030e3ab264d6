// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_GOAL_REFINEMENT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_GOAL_REFINEMENT_H

#include "worst_distances.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/edit/acceptance.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Makes triangles smaller at given points: splits an edge of each face of the result that is
/// nearest to a point. The edge is a feature or border edge if the farthest point of the face lies
/// beside such an edge, else the longest edge; another edge of the face if the edge admits no
/// vertex. The new vertex goes to the far point of the surface, or to the surface point nearest to
/// a far point of the result; if faces would then be inverted or intersect other faces, the vertex
/// stays in the middle of the edge. Then moves and flips raise small angles, and the largest
/// distances are lowered (worst_distances.h). The rest of the mesh does not change. Needs a result
/// without dead faces. Returns the number of new vertices. Cost: a closest-face map, a tree over
/// the faces, a search in the tree for each point, and the few poor faces.
///
/// maxGap: largest distance of a face from the surface after that, working units. mostNew: if more
/// faces have points, nothing is changed. work: the most work of the splits, see workOf.
int refineAt(const Surface& surface, const BoundaryCurves& curves,
			 const std::vector<FarPoint>& points, float maxGap, int mostNew, ResultMesh& result,
			 Workers& workers, std::int64_t work = workOf(Driver::Refinement));

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
