// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// gpremesh: geodesic Poisson-disk remeshing on the command line.
#include <vcg_extras/apps/gpremesh/commands/command_parser.h>
#include <vcg_extras/apps/gpremesh/commands/commands.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/base/stopwatch.h>

namespace {

using namespace gpr::app;

void run(int argc, char** argv, const Stopwatch& programClock)
{
	const CommandLine line = parseCommandLine(argc, argv);
	switch (line.command) {
	case Command::None:
		break;
	case Command::Remesh:
		runRemeshCommand(line, programClock);
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
	// Loading the program and its libraries took time before this line. No clock has measured this
	// time, but the processor time so far is most of the load time.
	const Stopwatch programClock(processorSeconds());
	return exitCodeOfRun([&] { run(argc, argv, programClock); });
}
