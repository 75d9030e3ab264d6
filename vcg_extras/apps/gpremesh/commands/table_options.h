// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_TABLE_OPTIONS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_TABLE_OPTIONS_H

#include <vcg_extras/io/options/given_options.h>

#include <CLI/App.hpp>

namespace gpr::app {

/// Adds an option to the command for every row of the tool that has a name on the command line and
/// is wanted; parsing fills given, which must stay where it is until then.
void addTableOptions(CLI::App& command, Tool tool, GivenOptions& given,
					 bool (*isWanted)(const Parameter&) = nullptr);

} // namespace gpr::app

#endif
