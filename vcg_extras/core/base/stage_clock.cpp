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
	whole_ = whole;
	finish();
	times_.clear();
	beginPart(pipeline_, whole);
}

const std::vector<StageTime>& StageClock::finish()
{
	if (key_ == nullptr) return times_;
	const Clock::time_point now = Clock::now();
	add({key_, std::chrono::duration<double>(now - stageStart_).count()});
	stageStart_ = now;
	key_        = nullptr;
	return times_;
}

void StageClock::add(const std::vector<StageTime>& stages)
{
	for (const StageTime& time : stages)
		add(time);
	stageStart_ = Clock::now();
}

void StageClock::add(const StageTime& time)
{
	const auto isSame  = [&](const StageTime& s) { return s.stage == time.stage; };
	const auto already = std::find_if(times_.begin(), times_.end(), isSame);
	if (already == times_.end())
		times_.push_back(time);
	else
		already->seconds += time.seconds;
}

} // namespace gpr
