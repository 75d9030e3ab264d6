// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_HAND_OUT_H
#define VCG_EXTRAS_CORE_OUTPUT_HAND_OUT_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/results.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// What a run set out to reach.
struct Expected {
	std::int64_t vertexNum = 0; ///< of the result; 0: no number was asked for
	std::int64_t keptNum   = 0; ///< of the caller's vertices that are to stay
};

/// The last stages: checks the result, tells about it and hands it out in the caller's terms.
/// Throws Failure where the audit fails.
void handOut(RunContext& run, const Surface& surface, const ResultMesh& result,
			 const Expected& expected, RemeshResult& out);

} // namespace gpr

#endif
