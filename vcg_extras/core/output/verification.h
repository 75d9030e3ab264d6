// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_VERIFICATION_H
#define VCG_EXTRAS_CORE_OUTPUT_VERIFICATION_H

#include "distance_proof.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>

namespace gpr {

/// What a run set out to reach, and what it knows of its result.
struct Expected {
	MeshFigures  input;                  ///< of the surface that was remeshed
	std::int64_t vertexNum          = 0; ///< of the result; 0: no number was asked for
	std::int64_t keptNum            = 0; ///< of the caller's vertices that are to stay
	float        largestFitDistance = 0; ///< of a vertex from the surface, working units
};

/// What was found out about a result.
struct Verification {
	MeshFigures   figures;
	AuditFigures  audit;
	CheckFigures  check;
	DistanceProof proof;                 ///< made here where it was not before
	std::int64_t  keptNum           = 0; ///< of the caller's vertices that were to stay
	double        constantForTarget = 0; ///< of eq. (1): see RemeshReport
};

/// With BoundaryMode::Smooth, adds the length of the result's border to the figures, and tells the
/// user how much shorter that is.
void tellSmoothBorder(RunContext& run, const Frame& frame, const ResultMesh& result,
					  BorderFigures& border);

/// Audits the finished mesh, thoroughly where the options ask for it, and notes what the user shall
/// know of it. Throws Failure where a promise is broken; `found` then tells which.
void verifyResult(RunContext& run, const Surface& surface, const ResultMesh& result,
				  const Expected& expected, Verification& found);

} // namespace gpr

#endif
