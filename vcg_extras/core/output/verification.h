// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_VERIFICATION_H
#define VCG_EXTRAS_CORE_OUTPUT_VERIFICATION_H

#include "thorough_check.h"

#include <cstdint>

namespace gpr {

/// The goals of a run and its knowledge about the result.
struct Expected {
	MeshFigures  input;         ///< of the remeshed surface
	std::int64_t vertexNum = 0; ///< of the result; 0: no target
	std::int64_t keptNum   = 0; ///< input vertices to be kept
};

/// The findings about a result.
struct Verification {
	MeshFigures   figures;
	AuditFigures  audit;
	CheckFigures  check;
	DistanceProof proof;                 ///< made here if not before
	std::int64_t  keptNum           = 0; ///< input vertices that were kept
	float         fitDistance       = 0; ///< of a vertex from its surface point, working units
	double        constantForTarget = 0; ///< for eq. (1): see RemeshReport
};

/// With BoundaryMode::Smooth, adds the border length of the result to the figures, and tells the
/// user how much shorter the border is.
void tellSmoothBorder(RunContext& run, const Frame& frame, const ResultMesh& result,
					  BorderFigures& border);

/// Audits the finished mesh, thoroughly with RemeshOptions::check, and writes notes for the user.
/// Throws Failure if a promise is broken; `found` then has the findings.
void verifyResult(RunContext& run, const Surface& surface, const ResultMesh& result,
				  const Expected& expected, Verification& found);

} // namespace gpr

#endif
