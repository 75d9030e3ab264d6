// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TESTS_CLI_PROGRAM_RUNNER_H
#define TESTS_CLI_PROGRAM_RUNNER_H

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace gpr_test {

/// What a program left behind.
struct ProgramResult {
	int         exitCode = -1; ///< 128 + signal when it was killed by one
	bool        timedOut = false;
	double      seconds  = 0;
	std::string out;
	std::string err;
};

/// A folder for one test, with gpremesh at hand; removed at the end.
class CliTest : public ::testing::Test {
protected:
	CliTest();
	~CliTest() override;

	/// Path of a file in the test's folder.
	std::string path(const std::string& name) const { return folder_ + "/" + name; }
	std::string put(const std::string& name, const std::string& content) const;
	std::string content(const std::string& filePath) const;
	bool        exists(const std::string& filePath) const;
	/// Names of all files in the test's folder.
	std::vector<std::string> files() const;

	/// Runs gpremesh to its end, or kills it after that many seconds.
	ProgramResult run(const std::vector<std::string>& arguments, double timeLimit = 30) const;
	/// The same, but sends it a signal as soon as it is ready to catch it.
	ProgramResult runAndSignal(const std::vector<std::string>& arguments, int signal) const;
	/// The same, but its standard error is a terminal.
	ProgramResult runOnTerminal(const std::vector<std::string>& arguments) const;

private:
	std::string folder_;

	std::string   stream(const std::string& name) const { return folder_ + "/.streams/" + name; }
	ProgramResult run(const std::vector<std::string>& arguments, double timeLimit, int signal,
					  const std::string& errorTo) const;
};

/// A failed run as gpremesh owes it: that exit code, nothing on standard output, and one sentence
/// that begins with the program's name.
void expectFailure(const ProgramResult& result, int exitCode,
				   const std::string& partOfSentence = "");

} // namespace gpr_test

#endif
