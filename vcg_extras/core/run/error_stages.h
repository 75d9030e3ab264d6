// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_ERROR_STAGES_H
#define VCG_EXTRAS_CORE_RUN_ERROR_STAGES_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/sampling/fine_spots.h>
#include <vcg_extras/core/sampling/target.h>

namespace gpr {

// The steps of a trial for an error bound.

/// The error bound of the options, and the vertex counts allowed in trials.
ErrorGoal errorGoalOf(const MeshView& input, const RemeshOptions& options,
					  const MeshExtent& extent);

/// Step Refinement: makes triangles smaller at places beyond the error bound, unless the places are
/// so many that all triangles are too large. Returns the number of added vertices.
RefinementFacts refineResult(RunContext& run, const ErrorGoal& goal, Products& made);

/// Step Error: proves the largest distance. If the distance is above the bound, the far places are
/// appended to `spots`, which the next trial gives smaller triangles. Cost: a proof, and a search
/// for each triangle perhaps beyond the bound, in parallel.
ErrorFacts measureError(RunContext& run, const ErrorGoal& goal, FineSpots& spots, Products& made);

} // namespace gpr

#endif
