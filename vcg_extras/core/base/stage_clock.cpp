// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "stage_clock.h"

#include <algorithm>

namespace gpr {

void StageClock::beginFirstPart(Pipeline other, double until)
{
	beginPart(other, {whole_.from, whole_.at(until)});
}

void StageClock::endFirstPart()
{
	beginPart(pipeline_, {part_.to, whole_.to});
}

void StageClock::beginPart(Pipeline pipeline, WorkShare part)
{
	current_ = pipeline;
	part_    = part;
	share_   = 0;
}

void StageClock::enter(Stage stage)
{
	finish();
	key_ = rowOf(stage).key;
	// Progress waits while stages are repeated.
	const double until = std::max(shareAtEnd(stage, current_), share_);
	workers_.enterStage(rowOf(stage).phrase, part_.at(share_), part_.at(until));
	share_ = until;
}

void StageClock::restart(WorkShare whole)
{
	whole_      = whole;
	stageStart_ = Clock::now();
	key_        = nullptr;
	times_.clear();
	beginPart(pipeline_, whole);
}

const std::vector<StageTime>& StageClock::finish()
{
	const double seconds = std::chrono::duration<double>(Clock::now() - stageStart_).count();
	stageStart_          = Clock::now();
	if (key_ == nullptr) return times_;
	const auto isIt    = [&](const StageTime& s) { return s.stage == key_; };
	const auto already = std::find_if(times_.begin(), times_.end(), isIt);
	if (already == times_.end())
		times_.push_back({key_, seconds});
	else
		already->seconds += seconds;
	key_ = nullptr;
	return times_;
}

} // namespace gpr
