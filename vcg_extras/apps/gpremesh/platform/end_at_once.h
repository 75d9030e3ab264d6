// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_PLATFORM_END_AT_ONCE_H
#define VCG_EXTRAS_APPS_GPREMESH_PLATFORM_END_AT_ONCE_H

#include <vcg_extras/io/base/run_limit.h>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace gpr::app {

/// Watches the run limit in a thread of its own, twenty times a second: at the limit the thread
/// ends the process with the reason and its exit code. For work without checks of the limit, such
/// as reading a file, and with nothing to clear away.
class EndAtOnce {
public:
	explicit EndAtOnce(const RunLimit& limit);
	~EndAtOnce();
	EndAtOnce(const EndAtOnce&)            = delete;
	EndAtOnce& operator=(const EndAtOnce&) = delete;

private:
	const RunLimit          limit_;
	std::mutex              mutex_;
	std::condition_variable wake_;
	bool                    isOver_ = false;
	std::thread             thread_;

	void watch();
};

} // namespace gpr::app

#endif
