// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_REMESH_COMMAND_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_REMESH_COMMAND_H

#include "command_line.h"

#include <vcg_extras/io/base/stopwatch.h>

namespace gpr::app {

/// Throws AppError (Failure) if OUT or the report cannot be written. For a call before long work.
void checkOutput(const CommandLine& line);

/// gpremesh remesh: reads IN, remeshes, writes OUT and the report, prints the summary. programClock
/// runs since the program's start. Throws AppError; writes OUT and the report only after success.
void runRemesh(const CommandLine& line, const Stopwatch& programClock);

/// The name of a level's file: the number, from 1 on, replaces levelPlace.
std::string pathOfLevel(const std::string& pattern, std::size_t level);

/// Whether all levels come into one file: OUT has no place for a number.
bool isOneFile(const CommandLine& line);

/// gpremesh levels: runRemesh for several sizes of an input, which is read and prepared once. Each
/// level has a file and a proof of its distance. A failed level ends the run; the files of earlier
/// levels stay.
void runLevels(const CommandLine& line, const Stopwatch& programClock);

} // namespace gpr::app

#endif
