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
		print(""); // the texts of the parser, too, must have arrived
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
	return int(ExitCode::Done);
}

void print(const std::string& text)
{
	std::fputs(text.c_str(), stdout);
	if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
		throw AppError(ExitCode::Failure, "cannot write to standard output");
}

void endRun(const CommandLine& line, const std::string& report, const std::string& summary,
			Outputs& outputs)
{
	if (!line.report.empty()) {
		auto file = std::make_unique<OutputFile>(line.report);
		file->text(report);
		file->finish();
		outputs.push_back(std::move(file));
	}
	if (!line.quiet) print(summary);
	for (const std::unique_ptr<Output>& output : outputs)
		output->commit();
}

void runRemeshCommand(const CommandLine& line, const Stopwatch& programClock)
{
	if (needsTiles(line))
		remeshInTiles(line, programClock);
	else
		runRemesh(line, programClock);
}

} // namespace gpr::app
