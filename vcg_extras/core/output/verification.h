// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_VERIFICATION_H
#define VCG_EXTRAS_CORE_OUTPUT_VERIFICATION_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>

namespace gpr {

/// What a run set out to reach.
struct Expected {
	std::int64_t vertexNum = 0; ///< of the result; 0: no number was asked for
	std::int64_t keptNum   = 0; ///< of the caller's vertices that are to stay
};

/// Audits the finished mesh, thoroughly where the options ask for it, and tells what it is like in
/// report and notes. Throws Failure where a promise is broken.
void verifyResult(RunContext& run, const Surface& surface, const ResultMesh& result,
				  const Expected& expected);

} // namespace gpr

#endif
