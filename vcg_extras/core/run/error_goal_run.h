// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_ERROR_GOAL_RUN_H
#define VCG_EXTRAS_CORE_RUN_ERROR_GOAL_RUN_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/results.h>

namespace gpr {

/// Finds the smallest count that keeps to the largest error of the options, by whole runs, and
/// returns the best of their results. Throws Failure where none keeps to it, unless the options
/// allow the nearest.
RemeshResult remeshForError(RunContext& run);

} // namespace gpr

#endif
