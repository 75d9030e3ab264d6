// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_BORDER_SMOOTHING_H
#define VCG_EXTRAS_CORE_RUN_BORDER_SMOOTHING_H

#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// With BoundaryMode::Smooth, cuts spikes off the surface that are narrower than an edge of the
/// result, and tells the report of it. True if the surface has changed, and p.area with it.
bool cutBorderSpikes(RunContext& run, Prepared& p);

/// With BoundaryMode::Smooth, tells the report how long the border of the result is, and the user
/// what was lost. Comes after describeInput, once.
void tellSmoothBorder(RunContext& run, const Surface& surface, const ResultMesh& result);

} // namespace gpr

#endif
