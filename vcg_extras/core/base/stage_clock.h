// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_STAGE_CLOCK_H
#define VCG_EXTRAS_CORE_BASE_STAGE_CLOCK_H

#include "stages.h"
#include "workers.h"

#include <vcg_extras/core/report.h>

#include <chrono>
#include <vector>

namespace gpr {

/// A part of all the work, in shares of 1.
struct WorkShare {
	double from = 0, to = 1;

	double at(double share) const { return from + share * (to - from); }
};

/// Times stages and tells progress. Stages follow each other without a gap, so that their seconds
/// add up to the whole.
class StageClock {
public:
	/// whole: of the call, where it runs the pipeline several times.
	StageClock(Workers& workers, Pipeline pipeline, WorkShare whole = {}) :
			workers_(workers), pipeline_(pipeline), whole_(whole), part_(whole), current_(pipeline),
			stageStart_(Clock::now())
	{
	}

	/// Begins anew, with other work of the call.
	void restart(WorkShare whole);

	/// The stages that follow are those of another pipeline, which does the work up to this share
	/// for the one of the clock.
	void beginFirstPart(Pipeline other, double until);
	/// From here on the pipeline of the clock does the rest.
	void endFirstPart();

	/// Ends the stage before and begins this one.
	void enter(Stage stage);
	/// Ends the stage before. The times of all stages so far, in the order of their first entry.
	const std::vector<StageTime>& finish();

private:
	using Clock = std::chrono::steady_clock;

	Workers&               workers_;
	Pipeline               pipeline_;
	WorkShare              whole_, part_; ///< part_: of the pipeline under way
	Pipeline               current_;
	Clock::time_point      stageStart_;
	std::vector<StageTime> times_;
	const char*            key_   = nullptr;
	double                 share_ = 0; ///< of the pipeline under way

	void beginPart(Pipeline pipeline, WorkShare part);
};

} // namespace gpr

#endif
