// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "stage_clock.h"

#include <algorithm>

namespace gpr {

void StageClock::enter(const char* key, const char* phrase, double until)
{
	finish();
	key_  = key;
	until = std::max(until, share_); // stages that are gone through again
	workers_.enterStage(phrase, from_ + share_ * span_, from_ + until * span_);
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
