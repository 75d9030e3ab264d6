// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_ARGUMENT_PARSER_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_ARGUMENT_PARSER_H

#include <cstdint>
#include <functional>
#include <list>
#include <string>
#include <vector>

namespace gpr::app {

/// Takes one value of an option, as the user wrote it. Throws AppError (Usage) for a wrong value.
using ValueTaker = std::function<void(const std::string& value)>;

/// An option ("--seed S"), a flag ("--quiet") or a positional argument ("IN") of a command.
struct Argument {
	std::string name;      ///< "--seed"; of a positional argument "IN"
	std::string valueName; ///< what the help calls the value; empty for flags and positional ones
	std::string help;      ///< lines
	ValueTaker  take;      ///< a flag takes "on"
	bool        isRequired = false;
	bool        takesMany  = false; ///< a positional argument: all that are left
	bool        isHidden   = false; ///< from help and manual page
};

/// A command with its arguments and the commands below it. A reference to an argument is good until
/// the next argument is added.
class CommandSpec {
public:
	CommandSpec(std::string name, std::string help);

	CommandSpec& addCommand(const std::string& name, const std::string& help);
	Argument&    addOption(const std::string& name, const std::string& valueName,
						   const std::string& help, ValueTaker take);
	void addFlag(const std::string& name, const std::string& help, std::function<void()> found);
	Argument& addPositional(const std::string& name, const std::string& help, ValueTaker take);

	std::string            name;
	std::string            help;   ///< lines
	std::string            footer; ///< the last lines of --help
	std::function<void()>  chosen; ///< called where the user names this command; may be empty
	std::vector<Argument>  options;
	std::vector<Argument>  positionals;
	std::list<CommandSpec> commands; ///< one of them must be named where there are any
};

/// Reads the words after the program's name. Options may stand anywhere after their command, as
/// "--seed 7" or
/// "--seed=7"; after "--" all words are positional. Returns the text of --help where that is asked
/// for, else an empty text after every value was taken. Throws AppError (Usage).
std::string parseArguments(const CommandSpec& program, const std::vector<std::string>& words);

/// Keeps a value as it is.
ValueTaker keepText(std::string& target);
ValueTaker keepEachText(std::vector<std::string>& target);

/// A whole number from least to most.
ValueTaker keepWhole(const std::string& option, int& target, int least, int most);

/// So many numbers with commas between them.
ValueTaker keepNumbers(const std::string& option, std::vector<double>& target, std::size_t count);

/// A number of bytes with a unit: 8G and 8GB are 8e9, 8GiB and 8Gi are 2^33.
ValueTaker keepBytes(const std::string& option, std::uint64_t& target);

} // namespace gpr::app

#endif
