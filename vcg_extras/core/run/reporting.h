// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_REPORTING_H
#define VCG_EXTRAS_CORE_RUN_REPORTING_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/base/stage_clock.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/results.h>

#include <string>
#include <vector>

namespace gpr {

/// The report and the notes about the products of a run. No other function writes a report, and
/// nothing reads a report before the run ends (scripts/check/report_reads).
Outcome tellOf(RunContext& run, const Products& made, const Decisions& decisions);
/// The same for a symmetric result: the report on the remeshed half, with the figures of the whole.
Outcome tellOfWhole(RunContext& run, const Products& made, RemeshReport half);

/// Adds the time since the start of a call with several runs, less the time of the run told of.
void addOtherRuns(StageClock::Clock::time_point start, Outcome& told);

/// Adds the times of the stages of a run on half of a surface to the clock of the whole.
void addTimes(const RemeshResult& half, StageClock& clock);

} // namespace gpr

#endif
