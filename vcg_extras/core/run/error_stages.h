// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_ERROR_STAGES_H
#define VCG_EXTRAS_CORE_RUN_ERROR_STAGES_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/sampling/fine_spots.h>
#include <vcg_extras/core/sampling/target.h>

namespace gpr {

// The steps of a trial for a largest error.

/// The error that the options ask for, and the counts that may be tried for it.
ErrorGoal errorGoalOf(const MeshView& input, const RemeshOptions& options,
					  const MeshExtent& extent);

/// Step Refinement: makes triangles smaller where the result does not keep to the goal,
/// unless these places are so many that triangles are too large on the whole.
RefinementFacts refineResult(RunContext& run, const ErrorGoal& goal, Products& made);

/// Step Error: proves the largest distance. Where it is beyond the goal, the places are
/// added to the spots where the next trial is to have smaller triangles. spots: of the trials
/// before. Cost: a proof, and a search for each triangle that may be beyond the goal, parallel.
ErrorFacts measureError(RunContext& run, const ErrorGoal& goal, FineSpots& spots, Products& made);

} // namespace gpr

#endif
