// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_COMMANDS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_COMMANDS_H

#include "command_line.h"

#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/base/stopwatch.h>

#include <functional>

// The commands of the program. Each throws AppError, and writes its files only after success.
// programClock runs since the program's start.

namespace gpr::app {

/// Runs the work of a program. Prints a failure as a sentence on standard error. Returns the exit
/// code.
int exitCodeOfRun(const std::function<void()>& work);

/// Prints on standard output. Throws AppError (Failure) if not all printed text has arrived: on a
/// full disk behind a redirection.
void print(const std::string& text);

/// Writes the report, prints the summary, and then puts all outputs in their places: a run that
/// fails leaves the older files.
void endRun(const CommandLine& line, const std::string& report, const std::string& summary,
			Outputs& outputs);

/// gpremesh remesh, in tiles if the memory is too small for the whole.
void runRemeshCommand(const CommandLine& line, const Stopwatch& programClock);

/// A remeshing of the whole: reads IN, remeshes, writes OUT and the report, prints the summary.
void runRemesh(const CommandLine& line, const Stopwatch& programClock);

/// Throws AppError (Failure) if OUT or the report cannot be written. For a call before long work.
void checkOutput(const CommandLine& line);

/// gpremesh levels: runRemesh for several sizes of an input, which is read and prepared once. Each
/// level has a file and a proof of its distance. A failed level ends the run, and no file is
/// written.
void runLevels(const CommandLine& line, const Stopwatch& programClock);

/// The name of a level's file: the number, from 1 on, replaces levelPlace.
std::string pathOfLevel(const std::string& pattern, std::size_t level);

/// Whether all levels come into one file: OUT has no place for a number.
bool isOneFile(const CommandLine& line);

/// Whether a run of 'gpremesh remesh --memory' has to be done in tiles. Reads the header of the
/// input. Throws AppError (BadInput) for an input that is too large and has a format that tiles do
/// not read.
bool needsTiles(const CommandLine& line);

/// Runs all steps of a run in tiles in turn, in the folder of the command line or in OUT.tiles;
/// continues an earlier run of the same command. Removes the folder at the end, but keeps the
/// folder after a failure.
void remeshInTiles(const CommandLine& line, const Stopwatch& programClock);

/// gpremesh tile: one step of a run in tiles. Prints a line of JSON.
void runTileStep(const CommandLine& line, const Stopwatch& programClock);

/// gpremesh features: reads IN, finds its features and writes OUT: IN's mesh with the strengths as
/// quality and colour, and with selected features.
void runFeatures(const CommandLine& line, const Stopwatch& programClock);

/// gpremesh info: reads IN and prints its counts, topology and quality.
void runInfo(const CommandLine& line);

/// gpremesh compare: runs the methods on one mesh and prints the table or JSON; with --html the
/// page too.
void runCompare(const CommandLine& line);

} // namespace gpr::app

#endif
