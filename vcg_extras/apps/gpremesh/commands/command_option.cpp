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
#include <sstream>

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

std::vector<double> parsePeriod(const std::string& word)
{
	std::vector<double> period;
	std::istringstream  parts(word);
	for (std::string part; std::getline(parts, part, ',');) {
		period.push_back(0);
		if (!parseNumber(part, period.back())) period.clear();
	}
	if (period.size() != 3)
		failUsage("--periodic takes three numbers, separated by commas, not '" + word + "'.");
	return period;
}

CommandOption transferOption(CommandLine& line)
{
	const auto take = [&line](const std::string& word) {
		if (word != "mean" && word != "nearest")
			failUsage("--transfer takes mean or nearest, not '" + word + "'.");
		line.transfer = word == "mean" ? Transfer::Mean : Transfer::Nearest;
	};
	return {
		"--transfer", "mean|nearest",
		"Values of the result's vertices: mean of the corners of the input face at the\n"
		"vertex, or value of the nearest corner. Default: nearest for labels (whole numbers) and\n"
		"for palette colours, mean for all other values",
		take, dataGroup};
}

CommandOption periodicOption(CommandLine& line)
{
	return {"--periodic", "X,Y,Z",
			"IN is a periodic cell with these lengths, 0 along an axis without a period. The\n"
			"vertices of opposite borders are one period apart. Implies --boundary match.\n"
			"Refused if the opposite borders of IN are not one period apart",
			[&line](const std::string& word) { line.period = parsePeriod(word); }, dataGroup};
}

} // namespace

CommandOption textOption(const char* option, const char* argument, const char* help,
						 std::string& kept, const char* group)
{
	return {option, argument, help, [&kept](const std::string& word) { kept = word; }, group};
}

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
	return textOption("--report", "FILE.json", help, line.report, everydayGroup);
}

CommandOption quietOption(CommandLine& line)
{
	return {"--quiet", "", "Show no progress and no summary, but errors",
			[&line](const std::string&) { line.quiet = true; }};
}

std::vector<CommandOption> valueOptions(CommandLine& line)
{
	return {textOption(
				"--regions", "NAME|off",
				"Property of the faces of IN with the labels of regions. Region borders are kept\n"
				"as feature lines, and the result gets the labels. Default: region, label,\n"
				"material, group, CellEntityIds or material_index; groups and materials of OBJ\n"
				"files, solids of STL files. off: no regions",
				line.regions, dataGroup),
			transferOption(line),
			textOption(
				"--sizes", "NAME",
				"Property of the vertices of IN with the wanted edge lengths, in mesh units. The\n"
				"lengths decide the number of vertices; a number of vertices or another size\n"
				"scales all lengths by one factor",
				line.sizes, dataGroup),
			periodicOption(line)};
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
