// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exit_code.h"
#include "platform.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
// The order counts: psapi.h needs windows.h.
#define NOMINMAX
#include <windows.h>
//
#include <psapi.h>

namespace gpr::app {

namespace {

volatile std::sig_atomic_t stopFlag = 0;

extern "C" void noteStop(int)
{
	stopFlag = 1; // Windows has restored the default, so that a second signal ends the program
}

[[noreturn]] void failToRead()
{
	failInput(std::strerror(errno));
}

} // namespace

FileContent::FileContent(const std::string& path)
{
	std::FILE* const file = std::fopen(path.c_str(), "rb");
	if (file == nullptr) failToRead();
	constexpr std::size_t block = 1 << 20;
	for (std::size_t got = block; got == block;) {
		const std::size_t used = copy_.size();
		copy_.resize(used + block);
		got = std::fread(copy_.data() + used, 1, block, file);
		copy_.resize(used + got);
	}
	const bool failed = std::ferror(file) != 0;
	std::fclose(file);
	if (failed) failToRead();
	data_ = copy_.data();
	size_ = copy_.size();
}

FileContent::~FileContent() = default;

// The content was read into memory of the process, which has to stay.
void FileContent::giveBackPages() const {}

bool errorIsTerminal()
{
	return ::_isatty(::_fileno(stderr)) != 0;
}

std::int64_t peakMemoryBytes()
{
	PROCESS_MEMORY_COUNTERS counters;
	const bool known = ::GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof counters);
	return known ? std::int64_t(counters.PeakWorkingSetSize) : 0;
}

double processorSeconds()
{
	FILETIME began, ended, kernel, user;
	if (!::GetProcessTimes(::GetCurrentProcess(), &began, &ended, &kernel, &user)) return 0;
	const auto ticks = [](const FILETIME& t) { // of 100 ns
		return double(std::uint64_t(t.dwHighDateTime) << 32 | t.dwLowDateTime);
	};
	return 1e-7 * (ticks(kernel) + ticks(user));
}

long processId()
{
	return long(::GetCurrentProcessId());
}

bool mayOverwrite(const std::string& path)
{
	constexpr int exists = 0, writable = 2;
	return ::_access(path.c_str(), exists) != 0 || ::_access(path.c_str(), writable) == 0;
}

std::FILE* openNewFile(const std::string& path)
{
	const int file =
		::_open(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY, _S_IREAD | _S_IWRITE);
	return file < 0 ? nullptr : ::_fdopen(file, "wb");
}

// Pictures are left out of pages made here: no program is started.
bool hasProgram(const std::string&)
{
	return false;
}

int runProgram(const std::vector<std::string>&, double)
{
	return -1;
}

void catchStopSignals()
{
	std::signal(SIGINT, noteStop);
	std::signal(SIGTERM, noteStop);
}

bool stopRequested()
{
	return stopFlag != 0;
}

} // namespace gpr::app
