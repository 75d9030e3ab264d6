// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_limit.h"

#include "exit_code.h"
#include "platform.h"

#include <algorithm>

namespace gpr::app {

const char* RunLimit::reason() const
{
	if (stopRequested()) return "cancelled; nothing was written.";
	if (seconds_ > 0 && clock_.seconds() > seconds_)
		return "not done within the time limit; nothing was written.";
	return nullptr;
}

void RunLimit::check() const
{
	if (const char* const sentence = reason()) throw AppError(ExitCode::Stopped, sentence);
}

void RunLimit::tell(const ProgressCallback& progress, double share, const char* phrase) const
{
	check();
	if (progress && !progress(share, phrase)) check();
}

double RunLimit::secondsLeft() const
{
	constexpr double least = 1e-3;
	return seconds_ > 0 ? std::max(least, seconds_ - clock_.seconds()) : 0;
}

} // namespace gpr::app
