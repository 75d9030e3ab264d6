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

/// The report and the notes of a run.
struct Told {
	RemeshReport             report;
	std::vector<std::string> notes;

	double stageSeconds() const;
	/// Adds the trials for an error bound. seconds: of all trials.
	void addTrials(double goal, int trialNum, double seconds, const std::string& outcome);
	/// Merges the report of the run on half of a symmetric surface. Figures of the whole mesh stay.
	void addHalf(RemeshReport half);
	template <class Result>
	void handOver(Result& out)
	{
		out.report = std::move(report);
		out.notes  = std::move(notes);
	}
};

/// The report and the notes about the products of a run. No other function writes a report, and
/// nothing reads a report before the run ends (scripts/check/report_reads).
Told tellOf(RunContext& run, const Products& made, const Decisions& decisions);

} // namespace gpr

#endif
