// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_REMESH_WORDS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_REMESH_WORDS_H

#include "command_option.h"

namespace gpr::app {

/// The words of `gpremesh remesh`: the options and files for a parser, and the resulting command
/// line. The program and the Python package have parsers of their own and share this class.
class RemeshWords {
public:
	RemeshWords()                              = default;
	RemeshWords(const RemeshWords&)            = delete; // the options refer to this
	RemeshWords& operator=(const RemeshWords&) = delete;

	/// All options, in the order in which --help shows them.
	std::vector<CommandOption> options();
	/// Takes the words that are no options, in order: IN, OUT, and more.
	void takeFiles(const std::vector<std::string>& files);
	/// The command line of the words. Throws AppError (Usage) with a sentence on any mistake.
	CommandLine line() const;

private:
	CommandLine              line_;
	GivenOptions             given_;
	std::vector<std::string> files_;
	std::string              folder_; ///< of --out-dir

	CommandOption outDirOption();
	CommandOption outputOption();
	void          sortFiles(CommandLine& line) const;
};

/// The description of `gpremesh remesh`.
extern const char* const remeshDescription;
/// The help texts of IN, of OUT, and of OUT of `gpremesh remesh`.
std::string inHelp();
std::string outHelp();
std::string outHelpOfRemesh();

/// The commands of the program.
extern const std::vector<std::string> commandNames;
/// The command of a name; Command::None for any other word.
Command commandNamed(const std::string& word);

/// Adds the command `remesh` in front if the first word is the name of a mesh: `gpremesh scan.ply
/// -o small.ply`.
std::vector<std::string> withCommand(std::vector<std::string> words);

} // namespace gpr::app

#endif
