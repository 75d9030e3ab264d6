// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "argument_parser.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/text/number_text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>

namespace gpr::app {

namespace {

constexpr std::size_t helpColumn = 30;
constexpr double      mostBytes  = 9e18; // of a 64-bit number

[[noreturn]] void failUsage(const std::string& sentence)
{
	throw AppError(ExitCode::Usage, sentence);
}

const Argument* findNamed(const std::vector<Argument>& options, std::string_view name)
{
	const auto found = std::find_if(options.begin(), options.end(),
									[name](const Argument& option) { return option.name == name; });
	return found == options.end() ? nullptr : &*found;
}

/// A name with its help beside it, or below where the name is too long.
std::string helpEntry(const std::string& name, const std::string& help)
{
	std::string text = "  " + name;
	if (text.size() >= helpColumn)
		text += '\n' + std::string(helpColumn, ' ');
	else
		text.resize(helpColumn, ' ');
	for (const char c : help) {
		text += c;
		if (c == '\n') text.append(helpColumn, ' ');
	}
	return text + '\n';
}

std::string usageLine(const CommandSpec& command, const std::string& path)
{
	std::string line = "Usage: " + path + " [OPTIONS]";
	for (const Argument& argument : command.positionals)
		line += " " + argument.name + (argument.takesMany ? "..." : "");
	return line + (command.commands.empty() ? "\n" : " COMMAND\n");
}

std::string helpOf(const CommandSpec& command, const std::string& path, bool isProgram)
{
	std::string text = command.help + "\n" + usageLine(command, path);
	if (!command.positionals.empty()) text += "\nPositionals:\n";
	for (const Argument& argument : command.positionals)
		text += helpEntry(argument.name + (argument.takesMany ? "..." : ""), argument.help);
	text += "\nOptions:\n" + helpEntry("-h,--help", "Print this help and exit");
	for (const Argument& option : command.options) {
		if (option.isHidden) continue;
		const std::string value = option.valueName.empty() ? "" : " " + option.valueName;
		text += helpEntry(option.name + value, option.help);
	}
	if (!command.commands.empty()) text += "\nCommands:\n";
	for (const CommandSpec& below : command.commands)
		text += helpEntry(below.name, below.help);
	return text + (isProgram || !command.footer.empty() ? "\n" + command.footer : "");
}

/// One pass over the words: what was found is taken only after all of them were understood.
class Parse {
public:
	Parse(const CommandSpec& program, const std::vector<std::string>& words) :
			words_(words), program_(&program), command_(&program), path_(program.name)
	{
	}

	std::string run()
	{
		bool onlyPositionals = false;
		for (at_ = 0; at_ < words_.size(); ++at_) {
			const std::string& word = words_[at_];
			if (!onlyPositionals && (word == "-h" || word == "--help"))
				return helpOf(*command_, path_, command_ == program_);
			if (!onlyPositionals && word == "--")
				onlyPositionals = true;
			else if (!onlyPositionals && word.size() > 1 && word[0] == '-')
				takeOption(word);
			else
				takePlainWord(word);
		}
		requireAll();
		for (const CommandSpec* command : chain_)
			if (command->chosen) command->chosen();
		for (const auto& [argument, value] : found_)
			argument->take(value);
		return "";
	}

private:
	[[noreturn]] void fail(const std::string& sentence) const
	{
		failUsage(sentence + " See " + path_ + " --help.");
	}

	bool wasFound(const Argument& argument) const
	{
		return std::any_of(found_.begin(), found_.end(),
						   [&](const auto& found) { return found.first == &argument; });
	}

	void takeOption(const std::string& word)
	{
		const std::size_t     sign   = word.find('=');
		const Argument* const option = findNamed(command_->options, word.substr(0, sign));
		if (option == nullptr) return refuse(word);
		if (option->valueName.empty()) {
			if (sign != std::string::npos) fail(option->name + " takes no value.");
			found_.emplace_back(option, "on");
			return;
		}
		if (wasFound(*option)) fail(option->name + " is given twice.");
		if (sign == std::string::npos && at_ + 1 == words_.size())
			fail(option->name + " needs a value, " + option->valueName + ".");
		found_.emplace_back(option,
							sign == std::string::npos ? words_[++at_] : word.substr(sign + 1));
	}

	void takePlainWord(const std::string& word)
	{
		for (const CommandSpec& below : command_->commands) {
			if (below.name != word) continue;
			command_ = &below;
			path_ += " " + word;
			chain_.push_back(&below);
			return;
		}
		const std::vector<Argument>& places = command_->positionals;
		if (place_ == places.size()) return refuse(word);
		found_.emplace_back(&places[place_], word);
		if (!places[place_].takesMany) ++place_;
	}

	/// Where help may follow yet, the first word that nothing expects is told at the end.
	void refuse(const std::string& word)
	{
		if (unexpected_.empty()) unexpected_ = word;
	}

	void requireAll() const
	{
		if (!unexpected_.empty()) fail("'" + unexpected_ + "' was not expected.");
		if (!command_->commands.empty() && !wasHandled()) fail("A command is required.");
		for (const std::vector<Argument>* list : {&command_->positionals, &command_->options}) {
			for (const Argument& argument : *list)
				if (argument.isRequired && !wasFound(argument))
					fail(argument.name + " is required.");
		}
	}

	/// Whether a flag does the work of a command, as --version.
	bool wasHandled() const
	{
		return std::any_of(found_.begin(), found_.end(), [this](const auto& found) {
			return findNamed(program_->options, found.first->name) == found.first;
		});
	}

	const std::vector<std::string>& words_;
	const CommandSpec*              program_;
	const CommandSpec*              command_; ///< the one that the words now belong to
	std::string                     path_;    ///< "gpremesh tile plan"
	std::size_t                     at_    = 0;
	std::size_t                     place_ = 0; ///< of the next positional argument
	std::vector<std::pair<const Argument*, std::string>> found_;
	std::vector<const CommandSpec*>                      chain_; ///< the commands that were named
	std::string                                          unexpected_;
};

/// The bytes of a unit; 0 where there is no such unit.
std::uint64_t bytesOfUnit(std::string unit)
{
	for (char& c : unit)
		c = char(std::tolower((unsigned char) c));
	if (unit.empty() || unit == "b") return 1;
	const std::size_t power    = std::string_view("kmgtpe").find(unit[0]);
	const std::string rest     = unit.substr(1);
	const bool        isBinary = rest == "i" || rest == "ib";
	if (power == std::string_view::npos || !(isBinary || rest.empty() || rest == "b")) return 0;
	std::uint64_t bytes = 1;
	for (std::size_t i = 0; i <= power; ++i)
		bytes *= isBinary ? 1024 : 1000;
	return bytes;
}

/// None where one of the words between the commas is no number.
std::vector<double> numbersIn(const std::string& value)
{
	std::vector<double> numbers;
	std::istringstream  words(value);
	for (std::string word; std::getline(words, word, ',');) {
		double number = 0;
		if (!parseNumber(word, number) || !std::isfinite(number)) return {};
		numbers.push_back(number);
	}
	return numbers;
}

} // namespace

CommandSpec::CommandSpec(std::string itsName, std::string itsHelp) :
		name(std::move(itsName)), help(std::move(itsHelp))
{
}

CommandSpec& CommandSpec::addCommand(const std::string& itsName, const std::string& itsHelp)
{
	return commands.emplace_back(itsName, itsHelp);
}

Argument& CommandSpec::addOption(const std::string& itsName, const std::string& valueName,
								 const std::string& itsHelp, ValueTaker take)
{
	return options.emplace_back(Argument{itsName, valueName, itsHelp, std::move(take)});
}

void CommandSpec::addFlag(const std::string& itsName, const std::string& itsHelp,
						  std::function<void()> found)
{
	addOption(itsName, "", itsHelp, [found = std::move(found)](const std::string&) { found(); });
}

Argument& CommandSpec::addPositional(const std::string& itsName, const std::string& itsHelp,
									 ValueTaker take)
{
	Argument argument{itsName, "", itsHelp, std::move(take)};
	argument.isRequired = true;
	return positionals.emplace_back(std::move(argument));
}

std::string parseArguments(const CommandSpec& program, const std::vector<std::string>& words)
{
	return Parse(program, words).run();
}

ValueTaker keepText(std::string& target)
{
	return [&target](const std::string& value) { target = value; };
}

ValueTaker keepEachText(std::vector<std::string>& target)
{
	return [&target](const std::string& value) { target.push_back(value); };
}

ValueTaker keepWhole(const std::string& option, int& target, int least, int most)
{
	return [&target, option, least, most](const std::string& value) {
		std::int64_t number = 0;
		if (!parseInteger(value, number) || number < least || number > most) {
			failUsage(option + " takes a whole number from " + std::to_string(least) + " to " +
					  std::to_string(most) + ", not '" + value + "'.");
		}
		target = int(number);
	};
}

ValueTaker keepNumbers(const std::string& option, std::vector<double>& target, std::size_t count)
{
	return [&target, option, count](const std::string& value) {
		target = numbersIn(value);
		if (target.size() != count) {
			failUsage(option + " takes " + std::to_string(count) +
					  " numbers with commas between them, not '" + value + "'.");
		}
	};
}

ValueTaker keepBytes(const std::string& option, std::uint64_t& target)
{
	return [&target, option](const std::string& value) {
		const std::size_t end    = std::min(value.find_first_not_of("0123456789."), value.size());
		const double      factor = double(bytesOfUnit(value.substr(end)));
		double            number = 0;
		const bool        isRead = parseNumber(value.substr(0, end), number) && factor > 0;
		if (!isRead || number * factor > mostBytes) {
			failUsage(option + " takes a number of bytes such as 8G, 500MB or 8GiB, not '" + value +
					  "'.");
		}
		target = std::uint64_t(number * factor);
	};
}

} // namespace gpr::app
