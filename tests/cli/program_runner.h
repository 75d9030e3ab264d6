// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TESTS_CLI_PROGRAM_RUNNER_H
#define TESTS_CLI_PROGRAM_RUNNER_H

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace gpr_test {

/// The outcome of a run of a program.
struct ProgramResult {
	int         exitCode = -1; ///< 128 + signal after a kill
	bool        timedOut = false;
	double      seconds  = 0;
	std::string out;
	std::string err;
};

/// A test with a folder for its files, removed at the end; runs gpremesh.
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

	/// Runs gpremesh to the end, or kills the program after `timeLimit` seconds.
	ProgramResult run(const std::vector<std::string>& arguments, double timeLimit = 30) const;
	/// Runs gpremesh and sends a signal as soon as the program has a handler for the signal.
	ProgramResult runAndSignal(const std::vector<std::string>& arguments, int signal) const;
	/// Runs gpremesh with a file or device as standard output.
	ProgramResult runPrintingTo(const std::string&              file,
								const std::vector<std::string>& arguments) const;
	/// Runs gpremesh with a terminal as standard error.
	ProgramResult runOnTerminal(const std::vector<std::string>& arguments) const;

private:
	std::string folder_;

	std::string   stream(const std::string& name) const { return folder_ + "/.streams/" + name; }
	ProgramResult run(const std::vector<std::string>& arguments, double timeLimit, int signal,
					  const std::string& outputTo, const std::string& errorTo) const;
};

/// Expects a failed run: this exit code, nothing on standard output, and one sentence after the
/// program's name.
void expectFailure(const ProgramResult& result, int exitCode,
				   const std::string& partOfSentence = "");

} // namespace gpr_test

#endif
