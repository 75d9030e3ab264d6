// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_INFO_COMMAND_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_INFO_COMMAND_H

#include "command_line.h"

namespace gpr::app {

/// gpremesh info: reads IN and prints its counts, topology and quality. Throws AppError.
void runInfo(const CommandLine& line);

} // namespace gpr::app

#endif
