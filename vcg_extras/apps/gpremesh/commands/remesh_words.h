// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_REMESH_WORDS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_REMESH_WORDS_H

#include "command_option.h"

namespace gpr::app {

/// The words of `gpremesh remesh`: what a parser may take, and what the words come to. The program
/// and the Python package have parsers of their own, and this in common.
class RemeshWords {
public:
	RemeshWords()                              = default;
	RemeshWords(const RemeshWords&)            = delete; // the options refer to this
	RemeshWords& operator=(const RemeshWords&) = delete;

	/// All options, in the order in which --help shows them.
	std::vector<CommandOption> options();
	/// The words that are no options, in order: IN, OUT, and more.
	void takeFiles(const std::vector<std::string>& files);
	/// What the words ask for. Throws AppError (Usage) with a sentence on any mistake.
	CommandLine line() const;

private:
	CommandLine              line_;
	GivenOptions             given_;
	std::vector<std::string> files_;
	std::string              folder_; ///< of --out-dir

	CommandOption outDirOption();
	CommandOption outputOption();
	CommandOption transferOption();
	CommandOption periodicOption();
	void          sortFiles(CommandLine& line) const;
};

/// What `gpremesh remesh` does.
extern const char* const remeshDescription;
/// What the words are that are no options.
extern const char* const inHelp;
extern const char* const outHelp;

/// The commands of the program.
extern const std::vector<std::string> commandNames;

/// The words with the command `remesh` in front where they begin with the name of a mesh:
/// `gpremesh scan.ply -o small.ply`.
std::vector<std::string> withCommand(std::vector<std::string> words);

} // namespace gpr::app

#endif
