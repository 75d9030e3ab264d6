// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_REMESH_COMMAND_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_REMESH_COMMAND_H

#include "command_line.h"

#include <vcg_extras/io/base/stopwatch.h>

namespace gpr::app {

/// Throws AppError (Failure) where OUT or the report could not be written. To be asked before long
/// work.
void checkOutput(const CommandLine& line);

/// gpremesh remesh: reads IN, remeshes, writes OUT and the report, prints the summary.
/// programClock runs since the program's start. Throws AppError; OUT and the report appear only
/// when all has gone well.
void runRemesh(const CommandLine& line, const Stopwatch& programClock);

/// The name of a level's file: the number, from 1 on, stands in the place of levelPlace.
std::string pathOfLevel(const std::string& pattern, std::size_t level);

/// Whether all levels come into one file: OUT has no place for a number.
bool isOneFile(const CommandLine& line);

/// gpremesh levels: the same for several sizes of one input, which is read and prepared once. Each
/// level has a file and a proof of its distance. A level that cannot be made ends the run; files of
/// those before stay.
void runLevels(const CommandLine& line, const Stopwatch& programClock);

} // namespace gpr::app

#endif
