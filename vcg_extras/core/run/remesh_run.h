// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_REMESH_RUN_H
#define VCG_EXTRAS_CORE_RUN_REMESH_RUN_H

#include "improvement.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/results.h>

namespace gpr {

/// The whole way from the input to the result. Where the largest distance counts it is measured,
/// too. Throws Failure where there is no result.
void remeshInput(RunContext& run, LargestDistance largest, RemeshResult& out);

} // namespace gpr

#endif
