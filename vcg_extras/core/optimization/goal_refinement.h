// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_GOAL_REFINEMENT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_GOAL_REFINEMENT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// The result of refineToGoal.
struct Refined {
	int  addedNum  = 0;     ///< vertices that came in
	bool keepsGoal = false; ///< no point is beyond the goal any more
};

/// Makes triangles smaller where a result and the surface are farther from each other than a goal,
/// round by round, unless these places are so many that triangles are too large on the whole. goal:
/// working units. Cost: in each round that of
/// placesBeyond, both ways, and of refineAt.
Refined refineToGoal(const Surface& surface, const BoundaryCurves& curves, double goal,
					 ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
