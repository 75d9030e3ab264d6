// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_REPORTING_H
#define VCG_EXTRAS_CORE_RUN_REPORTING_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/report.h>

#include <string>
#include <utility>
#include <vector>

namespace gpr {

/// Whatever a run has to tell, in its report and its notes.
struct Told {
	RemeshReport             report;
	std::vector<std::string> notes;

	double stageSeconds() const;
	/// Tells of the trials for an error, which took so many seconds in all.
	void addTrials(double goal, int trialNum, double seconds, const std::string& outcome);
	/// With what the run on half of a symmetric surface told: all but what the whole has, too.
	void addHalf(RemeshReport half);
	template <class Result>
	void handOver(Result& out)
	{
		out.report = std::move(report);
		out.notes  = std::move(notes);
	}
};

/// What a run has to tell of its products. Nothing else writes a report, and nothing reads one
/// before the run is over (scripts/check/report_reads).
Told tellOf(RunContext& run, const Products& made, const Decisions& decisions);

} // namespace gpr

#endif
