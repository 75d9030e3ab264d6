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

/// A range of the whole work, from 0 to 1.
struct WorkShare {
	double from = 0, to = 1;

	double at(double share) const { return from + share * (to - from); }
};

/// Measures the time of stages and reports progress. Stages follow each other without a gap, so
/// that their seconds add up to the whole time.
class StageClock {
public:
	using Clock = std::chrono::steady_clock;
	static double secondsSince(Clock::time_point start)
	{
		return std::chrono::duration<double>(Clock::now() - start).count();
	}

	/// whole: the range of this run, if a call runs the pipeline several times. The first stage
	/// counts from `start`.
	StageClock(Workers& workers, Pipeline pipeline, WorkShare whole = {},
			   Clock::time_point start = Clock::now()) :
			workers_(workers),
			pipeline_(pipeline), whole_(whole), part_(whole), current_(pipeline), stageStart_(start)
	{
	}

	/// Ends the stage under way, drops all times and starts anew, for another range.
	void restart(WorkShare whole);

	/// Switches to the stages of another pipeline for the first part of the work, up to share
	/// `until` of `whole`.
	void beginFirstPart(Pipeline other, double until);
	/// Switches back to the clock's pipeline for the rest.
	void endFirstPart();

	/// Ends the stage under way. Begins `stage` and its progress.
	void enter(Stage stage);
	/// Ends the stage under way. Returns the total time of each stage, first entered first. The
	/// next stage counts from here.
	const std::vector<StageTime>& finish();
	/// Adds the times of stages that another clock measured since finish().
	void add(const std::vector<StageTime>& stages);

private:
	Workers&               workers_;
	Pipeline               pipeline_;
	WorkShare              whole_, part_; ///< part_: range of the pipeline under way
	Pipeline               current_;
	Clock::time_point      stageStart_;
	std::vector<StageTime> times_;
	const char*            key_   = nullptr;
	double                 share_ = 0; ///< progress of the pipeline under way

	void beginPart(Pipeline pipeline, WorkShare part);
	void add(const StageTime& time);
};

} // namespace gpr

#endif
