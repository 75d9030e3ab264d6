// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"

#include <vcg_extras/io/base/exit_code.h>

#include <cstdio>
#include <new>

namespace gpr::app {

namespace {

/// Prints a failure as a sentence and returns its exit code.
int tell(ExitCode code, std::string sentence)
{
	if (sentence.empty() || sentence.back() != '.') sentence += '.';
	std::fprintf(stderr, "gpremesh: %s\n", sentence.c_str());
	return int(code);
}

} // namespace

int exitCodeOfRun(const std::function<void()>& work)
{
	try {
		work();
	}
	catch (const AppError& error) {
		return tell(error.code, error.what());
	}
	catch (const std::bad_alloc&) {
		return tell(ExitCode::Failure, "there is not enough memory");
	}
	catch (const std::exception& error) {
		return tell(ExitCode::Failure, error.what());
	}
	// All printed text must have arrived: a full disk behind a redirection is a failure.
	if (std::fflush(stdout) != 0) return tell(ExitCode::Failure, "cannot write to standard output");
	return int(ExitCode::Done);
}

void runRemeshCommand(const CommandLine& line, const Stopwatch& programClock)
{
	if (needsTiles(line))
		remeshInTiles(line, programClock);
	else
		runRemesh(line, programClock);
}

} // namespace gpr::app
