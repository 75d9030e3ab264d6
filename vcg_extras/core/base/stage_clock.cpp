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
	// Where stages are gone through again, progress waits.
	const double until = std::max(shareAtEnd(stage, current_), share_);
	workers_.enterStage(rowOf(stage).phrase, part_.at(share_), part_.at(until));
	share_ = until;
}

void StageClock::finish()
{
	const double seconds = std::chrono::duration<double>(Clock::now() - stageStart_).count();
	stageStart_          = Clock::now();
	if (key_ == nullptr) return;
	for (StageTime& s : report_.stages) {
		if (s.stage == key_) {
			s.seconds += seconds;
			return;
		}
	}
	report_.stages.push_back({key_, seconds});
}

} // namespace gpr
