// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_COMMAND_PARSER_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_COMMAND_PARSER_H

#include "command_line.h"

namespace gpr::app {

/// Reads the arguments of the program by CLI11. Prints --help and --version itself. Throws AppError
/// (Usage) with a sentence on any mistake.
CommandLine parseCommandLine(int argc, char** argv);

} // namespace gpr::app

#endif
