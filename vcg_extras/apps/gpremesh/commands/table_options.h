// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_TABLE_OPTIONS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_TABLE_OPTIONS_H

#include <vcg_extras/core/parameters.h>

#include <CLI/App.hpp>
#include <map>
#include <string>

namespace gpr::app {

/// The options of the engine's parameter table that the user gave, their values as words.
using GivenOptions = std::map<const Parameter*, std::string>;

/// Adds an option to the command for every row of the tool that has a name on the command line and
/// is wanted; parsing fills given, which must stay where it is until then.
void addTableOptions(CLI::App& command, Tool tool, GivenOptions& given,
					 bool (*isWanted)(const Parameter&) = nullptr);

/// Whether an option chooses the size of the result; "off" chooses none.
bool choosesSize(const Parameter& row, const std::string& word);

/// The engine's options from what was given; all others keep their defaults. Throws AppError
/// (Usage) for values of the wrong kind or out of range, and for more than one size.
RemeshOptions optionsOf(const GivenOptions& given);

/// The options that textOf has written. Throws AppError (Usage) for others.
RemeshOptions optionsOfText(const std::string& text);

/// What was given as one writes it, in alphabetical order: "--lambda 2 --percent 5".
std::string textOf(const GivenOptions& given, bool (*isWanted)(const Parameter&) = nullptr);

} // namespace gpr::app

#endif
