// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_ERROR_GUIDE_H
#define VCG_EXTRAS_CORE_RUN_ERROR_GUIDE_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/output/distance_proof.h>
#include <vcg_extras/core/sampling/fine_spots.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// What a trial of a search for the count of an error is told by those before it, and tells itself.
struct ErrorGuide {
	double    goal = 0; ///< largest error, mesh units
	FineSpots spots;    ///< of the trials before

	std::vector<FineSpot> found; ///< where this trial is too far from the input, or it from that
	double                share = 0; ///< of the area of the input, that is too far from the result
	double       growth   = 1; ///< of the count, if triangles get smaller there and stay elsewhere
	std::int64_t addedNum = 0; ///< vertices that came in at single places
};

/// Makes triangles smaller where a result does not keep to the goal of run.guide, round by round,
/// unless these places are so many that triangles are too large on the whole. Returns the number of
/// vertices that came in. Cost: in each round as findPlacesBeyond, and that of refineAt.
int refineToGoal(RunContext& run, const Surface& surface, const BoundaryCurves& curves,
				 ResultMesh& result);

/// Finds where a result does not keep to the goal, for run.guide. idealEdge: of its triangles,
/// working units. Cost: a search for each triangle that may not, parallel.
void findPlacesBeyond(RunContext& run, const Surface& surface, const ComparedSurfaces& both,
					  float idealEdge);

} // namespace gpr

#endif
