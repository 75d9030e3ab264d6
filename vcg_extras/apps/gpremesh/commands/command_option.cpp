// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_option.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/report/formatted_text.h>
#include <vcg_extras/io/text/number_text.h>
#include <vcg_extras/io/text/text_lines.h>

#include <algorithm>
#include <cctype>
#include <limits>

namespace gpr::app {

namespace {

std::string helpText(const Parameter& p)
{
	constexpr std::size_t width = 68; // beside the names of the options, for 100 columns
	const std::string     value = defaultText(p);
	return wrapped(commandHelp(p) + (value.empty() ? "" : " Default: " + value + "."), width);
}

/// Bytes of a unit; 0 for an unknown unit. K is a thousand, Ki is 1024.
std::uint64_t bytesOfUnit(const std::string& unit)
{
	if (unit.empty() || unit == "b") return 1;
	const std::size_t   power = std::string("kmgtpe").find(unit[0]);
	const std::string   rest  = unit.substr(1);
	const std::uint64_t step  = rest == "i" || rest == "ib" ? 1024 : 1000;
	if (power == std::string::npos || (step == 1000 && !rest.empty() && rest != "b")) return 0;
	std::uint64_t bytes = step;
	for (std::size_t i = 0; i < power; ++i)
		bytes *= step;
	return bytes;
}

std::uint64_t parseBytes(const std::string& word)
{
	const auto end    = std::find_if_not(word.begin(), word.end(),
										 [](unsigned char c) { return std::isdigit(c) != 0; });
	auto       letter = end;
	while (letter != word.end() && *letter == ' ')
		++letter;
	const std::uint64_t unit   = bytesOfUnit(lowerCase(std::string(letter, word.end())));
	std::int64_t        number = 0;
	const bool          isRead = parseInteger(std::string(word.begin(), end), number);
	if (!isRead || unit == 0 ||
		std::uint64_t(number) > std::numeric_limits<std::uint64_t>::max() / unit) {
		failUsage("--memory takes a whole number with a unit, such as 8G, not '" + word + "'.");
	}
	return std::uint64_t(number) * unit;
}

} // namespace

std::vector<CommandOption> tableOptions(Tool tool, GivenOptions& given,
										bool (*isWanted)(const Parameter&))
{
	std::vector<CommandOption> options;
	for (const Parameter& p : parametersOf(tool)) {
		if (std::string(p.option).empty() || (isWanted != nullptr && !isWanted(p))) continue;
		const auto keep = [row = &p, &given](const std::string& word) { given[row] = word; };
		options.push_back({p.option, p.argument, helpText(p), keep, p.group});
	}
	return options;
}

CommandOption reportOption(CommandLine& line, const char* help)
{
	return {"--report", "FILE.json", help,
			[&line](const std::string& word) { line.report = word; }};
}

CommandOption quietOption(CommandLine& line)
{
	return {"--quiet", "", "Show no progress and no summary, but errors",
			[&line](const std::string&) { line.quiet = true; }};
}

CommandOption memoryOption(CommandLine& line)
{
	return {"--memory", "SIZE",
			"Memory to use at most, such as 8G. If IN needs more, IN is cut into tiles, each\n"
			"tile is condensed separately, and the condensed tiles are remeshed together",
			[&line](const std::string& word) { line.tiles.memoryBytes = parseBytes(word); },
			largeMeshGroup};
}

CommandOption tilesOutOption(CommandLine& line)
{
	const auto take = [&line](const std::string& word) {
		std::int64_t number = 0;
		if (!parseInteger(word, number) || number < 1 || number > 10000) {
			failUsage("--tiles-out takes a whole number from 1 to 10000, not '" + word + "'.");
		}
		line.outTileNum = int(number);
	};
	return {"--tiles-out", "T",
			"Write OUT as a folder of T binary PLY files with coinciding borders, and of\n"
			"tiles.json with the bounding box of each file",
			take, largeMeshGroup};
}

} // namespace gpr::app
