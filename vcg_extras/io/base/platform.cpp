// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "platform.h"

#include "exit_code.h"
#include "stopwatch.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#ifdef __APPLE__
#include <crt_externs.h>
#endif

namespace gpr::app {

namespace {

volatile std::sig_atomic_t stopFlag = 0;

extern "C" void noteStop(int)
{
	stopFlag = 1;
}

[[noreturn]] void failToRead()
{
	failInput(std::strerror(errno));
}

/// Closes a file descriptor at the end of a scope.
class Descriptor {
public:
	explicit Descriptor(const std::string& path) :
			number(::open(path.c_str(), O_RDONLY | O_CLOEXEC))
	{
	}
	~Descriptor()
	{
		if (number >= 0) ::close(number);
	}
	Descriptor(const Descriptor&)            = delete;
	Descriptor& operator=(const Descriptor&) = delete;

	int number;
};

std::vector<char> readAll(int descriptor)
{
	constexpr std::size_t block = 1 << 20;
	std::vector<char>     content;
	while (true) {
		const std::size_t used = content.size();
		content.resize(used + block);
		const ssize_t got = ::read(descriptor, content.data() + used, block);
		if (got < 0) failToRead();
		content.resize(used + std::size_t(got));
		if (got == 0) return content;
	}
}

/// POSIX has environ without a header, and a module of macOS has a function in its place.
char** environment()
{
#ifdef __APPLE__
	return *::_NSGetEnviron();
#else
	return environ;
#endif
}

/// Reads the pages of a mapping at once, on systems with MAP_POPULATE.
#ifdef MAP_POPULATE
constexpr int mapAtOnce = MAP_POPULATE;
#else
constexpr int mapAtOnce = 0;
#endif

/// Starts a program in a process group of its own, so that the program and all its children can be
/// ended together.
bool startProgram(const std::vector<std::string>& words, pid_t& process)
{
	std::vector<char*> arguments;
	arguments.reserve(words.size() + 1);
	for (const std::string& w : words)
		arguments.push_back(const_cast<char*>(w.c_str()));
	arguments.push_back(nullptr);
	posix_spawn_file_actions_t actions;
	posix_spawnattr_t          attributes;
	::posix_spawn_file_actions_init(&actions);
	::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
	::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
	::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
	::posix_spawnattr_init(&attributes);
	::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
	::posix_spawnattr_setpgroup(&attributes, 0);
	const int error = ::posix_spawnp(&process, arguments[0], &actions, &attributes,
									 arguments.data(), environment());
	::posix_spawnattr_destroy(&attributes);
	::posix_spawn_file_actions_destroy(&actions);
	return error == 0;
}

} // namespace

FileContent::FileContent(const std::string& path)
{
	const Descriptor file(path);
	struct stat      status;
	if (file.number < 0 || ::fstat(file.number, &status) != 0) failToRead();
	if (S_ISDIR(status.st_mode)) failInput("the path names a folder");
	if (S_ISREG(status.st_mode) && status.st_size > 0) {
		void* const at = ::mmap(nullptr, std::size_t(status.st_size), PROT_READ,
								MAP_PRIVATE | mapAtOnce, file.number, 0);
		if (at != MAP_FAILED) {
			mapping_ = at;
			data_    = static_cast<const char*>(at);
			size_    = std::size_t(status.st_size);
			return;
		}
	}
	copy_ = readAll(file.number);
	data_ = copy_.data();
	size_ = copy_.size();
}

FileContent::~FileContent()
{
	if (mapping_ != nullptr) ::munmap(mapping_, size_);
}

void FileContent::giveBackPages() const
{
	if (mapping_ != nullptr) ::madvise(mapping_, size_, MADV_DONTNEED);
}

bool errorIsTerminal()
{
	return ::isatty(STDERR_FILENO) == 1;
}

std::int64_t peakMemoryBytes()
{
	// getrusage still counts the parent program after exec, so the file is read instead.
	std::ifstream status("/proc/self/status");
	std::string   word;
	while (status >> word) {
		std::int64_t kilobytes = 0;
		if (word == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
	}
#ifdef __APPLE__
	constexpr std::int64_t unit = 1;
#else
	constexpr std::int64_t unit = 1024;
#endif
	struct rusage usage;
	return ::getrusage(RUSAGE_SELF, &usage) == 0 ? std::int64_t(usage.ru_maxrss) * unit : 0;
}

double processorSeconds()
{
	struct timespec used;
	if (::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used) != 0) return 0;
	return double(used.tv_sec) + 1e-9 * double(used.tv_nsec);
}

long processId()
{
	return long(::getpid());
}

bool mayOverwrite(const std::string& path)
{
	return ::access(path.c_str(), F_OK) != 0 || ::access(path.c_str(), W_OK) == 0;
}

std::FILE* openNewFile(const std::string& path)
{
	return std::fopen(path.c_str(), "wbx");
}

bool hasProgram(const std::string& name)
{
	const char* const  path = std::getenv("PATH");
	std::istringstream folders(path != nullptr ? path : "");
	for (std::string folder; std::getline(folders, folder, ':');) {
		if (folder.empty()) folder = ".";
		if (::access(folder.append("/").append(name).c_str(), X_OK) == 0) return true;
	}
	return false;
}

int runProgram(const std::vector<std::string>& words, double secondsAllowed)
{
	pid_t process = 0;
	if (!startProgram(words, process)) return -1;
	const Stopwatch clock;
	int             status = 0;
	while (::waitpid(process, &status, WNOHANG) == 0) {
		if (clock.seconds() > secondsAllowed || stopRequested()) {
			::kill(-process, SIGTERM);
			std::this_thread::sleep_for(std::chrono::seconds(1));
			::kill(-process, SIGKILL);
			::waitpid(process, &status, 0);
			return -1;
		}
		std::this_thread::sleep_for(std::chrono::milliseconds(10));
	}
	return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void catchStopSignals()
{
	struct sigaction action = {};
	action.sa_handler       = noteStop;
	action.sa_flags         = int(SA_RESETHAND) | SA_RESTART;
	::sigaction(SIGINT, &action, nullptr);
	::sigaction(SIGTERM, &action, nullptr);
}

bool stopRequested()
{
	return stopFlag != 0;
}

} // namespace gpr::app
