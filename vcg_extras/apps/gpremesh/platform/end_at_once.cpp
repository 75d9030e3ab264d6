// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "end_at_once.h"

#include <vcg_extras/io/base/exit_code.h>

#include <chrono>
#include <cstdio>

namespace gpr::app {

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
		std::_Exit(int(ExitCode::Stopped)); // frees nothing, as other threads may use everything
	}
}

} // namespace gpr::app
