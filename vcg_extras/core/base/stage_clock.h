// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_STAGE_CLOCK_H
#define VCG_EXTRAS_CORE_RUN_STAGE_CLOCK_H

#include "workers.h"

#include <vcg_extras/core/report.h>

#include <chrono>

namespace gpr {

/// Times stages and tells progress. Stages follow each other without a gap, so that their seconds
/// add up to the whole.
class StageClock {
public:
	StageClock(Workers& workers, RemeshReport& report) :
			workers_(workers), report_(report), stageStart_(Clock::now())
	{
	}
	~StageClock() { finish(); }
	StageClock(const StageClock&)            = delete;
	StageClock& operator=(const StageClock&) = delete;

	/// The run is not all of the work but that from `from` to `to`, shares of 1.
	void tellWithin(double from, double to)
	{
		from_ = from;
		span_ = to - from;
	}

	/// Ends the stage before and begins one: its key in the report, the phrase that users read, and
	/// the share of the run at its end.
	void enter(const char* key, const char* phrase, double until);

private:
	using Clock = std::chrono::steady_clock;

	Workers&          workers_;
	RemeshReport&     report_;
	double            from_ = 0, span_ = 1;
	Clock::time_point stageStart_;
	const char*       key_   = nullptr;
	double            share_ = 0;

	void finish();
};

} // namespace gpr

#endif
