// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_PROGRAM_RUN_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_PROGRAM_RUN_H

#include "command_line.h"

#include <vcg_extras/io/base/stopwatch.h>

#include <functional>

namespace gpr::app {

/// Runs the work of a program. Prints a failure as a sentence on standard error. Returns the exit
/// code; a full disk behind standard output is a failure.
int exitCodeOfRun(const std::function<void()>& work);

/// gpremesh remesh, in tiles if the memory is too small for the whole. Throws AppError.
void runRemeshCommand(const CommandLine& line, const Stopwatch& programClock);

} // namespace gpr::app

#endif
