// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_COMMAND_OPTION_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_COMMAND_OPTION_H

#include "command_line.h"

#include <functional>
#include <string>
#include <vector>

namespace gpr::app {

/// An option of a command, for any parser of words.
struct CommandOption {
	std::string option;   ///< "--report"; with a short form "-o,--output"
	std::string argument; ///< placeholder in --help: "FILE.json"; empty: a switch
	std::string help;     ///< lines of at most 80 columns
	/// Takes the given word, or "on" for a switch. Throws AppError (Usage).
	std::function<void(const std::string&)> take;
	std::string group = everydayGroup; ///< heading in --help-all; --help shows everydayGroup only
};

/// The options of the engine's parameter table. `given` receives the words.
std::vector<CommandOption> tableOptions(Tool tool, GivenOptions& given,
										bool (*isWanted)(const Parameter&) = nullptr);

/// The groups of options for files and values, and for meshes larger than the memory.
constexpr const char* dataGroup      = "Files, regions and values of the input";
constexpr const char* largeMeshGroup = "Meshes larger than the memory";

/// An option that keeps its word.
CommandOption textOption(const char* option, const char* argument, const char* help,
						 std::string& kept, const char* group);

// Options of several commands; each fills the line.
CommandOption reportOption(CommandLine& line, const char* help);
CommandOption quietOption(CommandLine& line);
CommandOption memoryOption(CommandLine& line);
CommandOption tilesOutOption(CommandLine& line);

/// Regions, transfer of values, sizes and the period; each fills the line.
std::vector<CommandOption> valueOptions(CommandLine& line);

} // namespace gpr::app

#endif
