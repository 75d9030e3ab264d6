// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_limit.h"

#include "exit_code.h"
#include "platform.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

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

double RunLimit::secondsLeft() const
{
	constexpr double least = 1e-3;
	return seconds_ > 0 ? std::max(least, seconds_ - clock_.seconds()) : 0;
}

EndAtOnce::EndAtOnce(const RunLimit& limit) : limit_(limit), thread_([this] { watch(); }) {}

EndAtOnce::~EndAtOnce()
{
	{
		const std::lock_guard<std::mutex> lock(mutex_);
		isOver_ = true;
	}
	wake_.notify_one();
	thread_.join();
}

void EndAtOnce::watch()
{
	constexpr std::chrono::milliseconds period(50);
	std::unique_lock<std::mutex>        lock(mutex_);
	while (!wake_.wait_for(lock, period, [this] { return isOver_; })) {
		const char* const sentence = limit_.reason();
		if (sentence == nullptr) continue;
		std::fprintf(stderr, "gpremesh: %s\n", sentence);
		std::_Exit(int(ExitCode::Stopped)); // nothing is taken down that may be in use
	}
}

} // namespace gpr::app
