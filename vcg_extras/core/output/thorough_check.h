// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_THOROUGH_CHECK_H
#define VCG_EXTRAS_CORE_OUTPUT_THOROUGH_CHECK_H

#include "distance_proof.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/report.h>

#include <string>

namespace gpr {

/// What the audit leaves out because it costs as much as a run: self-intersections, and
/// distances found by nearest points, which trust none of the run's own surface points. The input's
/// ones are looked for only where the result has some. Lengths of the figures are in working
/// units. both: of the same meshes. Cost: O(F log F) of both, parallel.
CheckFigures checkThoroughly(const Surface& surface, const ResultMesh& result,
							 const ComparedSurfaces& both, Workers& workers);

/// What is promised and not kept, as one sentence; empty if all is: no faces intersect where
/// none did in the input, and no vertex is farther from the input than the fit moved it, which is
/// fitDistance in working units.
std::string describeFailure(const CheckFigures& figures, double fitDistance);

} // namespace gpr

#endif
