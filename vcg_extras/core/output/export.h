// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_EXPORT_H
#define VCG_EXTRAS_CORE_OUTPUT_EXPORT_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/results.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Last stage: writes the mesh, and what the options ask for beside it, in the caller's frame and
/// numbering. Throws Failure where rounding to that frame leaves a face without area.
void exportResult(RunContext& run, const Surface& surface, const ResultMesh& result,
				  RemeshResult& out);

} // namespace gpr

#endif
