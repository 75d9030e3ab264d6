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

} // namespace gpr::app

#endif
