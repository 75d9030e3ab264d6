// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// gpremesh: geodesic Poisson-disk remeshing on the command line.
#include <vcg_extras/apps/gpremesh/commands/command_line.h>
#include <vcg_extras/apps/gpremesh/commands/features_command.h>
#include <vcg_extras/apps/gpremesh/commands/info_command.h>
#include <vcg_extras/apps/gpremesh/commands/remesh_command.h>
#include <vcg_extras/apps/gpremesh/compare/compare_command.h>
#include <vcg_extras/apps/gpremesh/tiles/tile_run.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/base/stopwatch.h>

#include <cstdio>
#include <new>
#include <string>

namespace {

using namespace gpr::app;

/// Shows a failure as one sentence and returns its exit code.
int tell(ExitCode code, std::string sentence)
{
	if (sentence.empty() || sentence.back() != '.') sentence += '.';
	std::fprintf(stderr, "gpremesh: %s\n", sentence.c_str());
	return int(code);
}

void run(int argc, char** argv, const Stopwatch& programClock)
{
	const CommandLine line = parseCommandLine(argc, argv);
	switch (line.command) {
	case Command::None:
		break;
	case Command::Remesh:
		if (needsTiles(line))
			remeshInTiles(line, programClock);
		else
			runRemesh(line, programClock);
		break;
	case Command::Levels:
		runLevels(line, programClock);
		break;
	case Command::Tile:
		runTileStep(line, programClock);
		break;
	case Command::Info:
		runInfo(line);
		break;
	case Command::Compare:
		runCompare(line);
		break;
	case Command::Features:
		runFeatures(line, programClock);
		break;
	}
}

} // namespace

int main(int argc, char** argv)
{
	// Loading the program and its libraries took time before this line; no clock says how much of
	// it, but the processor time used so far is most of it.
	const Stopwatch programClock(processorSeconds());
	try {
		run(argc, argv, programClock);
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
	// What was printed must have arrived: a full disk behind a redirection is a failure.
	if (std::fflush(stdout) != 0) return tell(ExitCode::Failure, "cannot write to standard output");
	return int(ExitCode::Done);
}
