// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMAND_LINE_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMAND_LINE_H

#include <vcg_extras/core/options.h>

#include <string>

namespace gpr::app {

enum class Command {
	None, ///< --help, --version or --manual-page: printed already
	Remesh,
	Info,
	Compare,
	Features,
};

/// What the user asked for, checked.
struct CommandLine {
	Command       command = Command::None;
	std::string   input;
	std::string   output; ///< remesh and features only
	std::string   report; ///< remesh and features only; empty = none
	bool          quiet     = false;
	bool          json      = false; ///< info and compare only
	bool          isotropic = false; ///< compare only
	int           runNum    = 1;     ///< compare only
	std::string   htmlFolder;        ///< compare only; empty = no page
	RemeshOptions options;           ///< all but info
	std::string   optionsText;       ///< these as the user gave them: "--lambda 2 --fit off"
};

/// Reads the arguments; the remeshing options are made from the engine's parameter table. Prints
/// --help and --version itself. Throws AppError (Usage) with a sentence on any mistake.
CommandLine parseCommandLine(int argc, char** argv);

} // namespace gpr::app

#endif
