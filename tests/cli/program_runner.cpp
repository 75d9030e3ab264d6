// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "program_runner.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace gpr_test {

namespace fs = std::filesystem;

namespace {

/// The path in the variable GPREMESH, else the program built by CMake.
std::string programPath()
{
	const char* const chosen = std::getenv("GPREMESH");
	return chosen != nullptr ? chosen : GPREMESH_PATH;
}

void redirect(int descriptor, const std::string& file)
{
	const int target = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOCTTY, 0600);
	if (target < 0 || ::dup2(target, descriptor) < 0) ::_exit(126);
}

pid_t start(const std::vector<std::string>& arguments, const std::string& out,
			const std::string& err)
{
	std::vector<char*> argv;
	for (const std::string& a : arguments)
		argv.push_back(const_cast<char*>(a.c_str()));
	argv.push_back(nullptr);
	const pid_t child = ::fork();
	if (child != 0) return child;
	redirect(STDOUT_FILENO, out);
	redirect(STDERR_FILENO, err);
	::execv(argv[0], argv.data());
	::_exit(127);
}

/// Whether the process has set a handler for the signal.
bool catches(pid_t process, int signal)
{
	std::ifstream status("/proc/" + std::to_string(process) + "/status");
	std::string   word;
	while (status >> word) {
		if (word != "SigCgt:") continue;
		status >> word;
		return (std::stoull(word, nullptr, 16) >> (signal - 1) & 1) != 0;
	}
	return false;
}

int exitCodeOf(int status)
{
	return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string fileContent(const std::string& file)
{
	std::ifstream     stream(file, std::ios::binary);
	std::stringstream text;
	text << stream.rdbuf();
	return text.str();
}

} // namespace

CliTest::CliTest()
{
	std::string pattern = (fs::temp_directory_path() / "gpremesh-test-XXXXXX").string();
	if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
	folder_ = pattern;
	fs::create_directory(folder_ + "/.streams");
}

CliTest::~CliTest()
{
	std::error_code error;
	fs::remove_all(folder_, error);
}

std::string CliTest::put(const std::string& name, const std::string& content) const
{
	std::ofstream(path(name), std::ios::binary) << content;
	return path(name);
}

std::string CliTest::content(const std::string& filePath) const
{
	return fileContent(filePath);
}

bool CliTest::exists(const std::string& filePath) const
{
	return fs::exists(filePath);
}

std::vector<std::string> CliTest::files() const
{
	std::vector<std::string> names;
	for (const auto& entry : fs::directory_iterator(folder_)) {
		if (entry.is_regular_file()) names.push_back(entry.path().filename().string());
	}
	std::sort(names.begin(), names.end());
	return names;
}

ProgramResult CliTest::run(const std::vector<std::string>& arguments, double timeLimit) const
{
	return run(arguments, timeLimit, 0, stream("out"), stream("err"));
}

ProgramResult CliTest::runAndSignal(const std::vector<std::string>& arguments, int signal) const
{
	return run(arguments, 60, signal, stream("out"), stream("err"));
}

ProgramResult CliTest::runPrintingTo(const std::string&              file,
									 const std::vector<std::string>& arguments) const
{
	return run(arguments, 60, 0, file, stream("err"));
}

ProgramResult CliTest::runOnTerminal(const std::vector<std::string>& arguments) const
{
	const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
	if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) {
		throw std::runtime_error("no pseudo terminal");
	}
	// The terminal holds the program's whole output until the program has ended.
	ProgramResult result = run(arguments, 60, 0, stream("out"), ::ptsname(terminal));
	char          text[4096];
	for (ssize_t got; (got = ::read(terminal, text, sizeof text)) > 0;) {
		result.err.append(text, std::size_t(got));
	}
	::close(terminal);
	return result;
}

ProgramResult CliTest::run(const std::vector<std::string>& arguments, double timeLimit, int signal,
						   const std::string& outputTo, const std::string& errorTo) const
{
	using Clock = std::chrono::steady_clock;
	std::vector<std::string> all{programPath()};
	all.insert(all.end(), arguments.begin(), arguments.end());
	const auto    begin = Clock::now();
	const pid_t   child = start(all, outputTo, errorTo);
	ProgramResult result;
	int           status = 0;
	while (::waitpid(child, &status, WNOHANG) == 0) {
		result.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
		if (result.seconds > timeLimit && !result.timedOut) {
			result.timedOut = true;
			::kill(child, SIGKILL);
		}
		if (signal != 0 && catches(child, signal)) {
			::kill(child, signal);
			signal = 0;
		}
		std::this_thread::sleep_for(std::chrono::microseconds(500));
	}
	result.seconds  = std::chrono::duration<double>(Clock::now() - begin).count();
	result.exitCode = exitCodeOf(status);
	if (outputTo == stream("out")) result.out = fileContent(outputTo);
	if (errorTo == stream("err")) result.err = fileContent(errorTo);
	return result;
}

void expectFailure(const ProgramResult& result, int exitCode, const std::string& partOfSentence)
{
	EXPECT_FALSE(result.timedOut);
	EXPECT_EQ(result.exitCode, exitCode) << result.err;
	EXPECT_EQ(result.out, "");
	EXPECT_EQ(result.err.rfind("gpremesh: ", 0), 0u) << result.err;
	EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
	ASSERT_GE(result.err.size(), 2u);
	EXPECT_EQ(result.err.substr(result.err.size() - 2), ".\n") << result.err;
	EXPECT_NE(result.err.find(partOfSentence), std::string::npos) << result.err;
}

} // namespace gpr_test
