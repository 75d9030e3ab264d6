// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_FEATURES_COMMAND_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_FEATURES_COMMAND_H

#include "command_line.h"

#include <vcg_extras/io/base/stopwatch.h>

namespace gpr::app {

/// gpremesh features: reads IN, finds its features and writes OUT: IN's mesh with the strengths as
/// quality and colour, and with selected features. Throws AppError; writes OUT and the report only
/// after success. programClock: the clock of the time limit.
void runFeatures(const CommandLine& line, const Stopwatch& programClock);

} // namespace gpr::app

#endif
