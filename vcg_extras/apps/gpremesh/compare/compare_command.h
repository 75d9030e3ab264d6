// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_COMMAND_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_COMMAND_H

#include <vcg_extras/apps/gpremesh/commands/command_line.h>

namespace gpr::app {

/// gpremesh compare: runs the methods on one mesh and prints the table or JSON; with --html the
/// page too. Throws AppError on failure.
void runCompare(const CommandLine& line);

} // namespace gpr::app

#endif
