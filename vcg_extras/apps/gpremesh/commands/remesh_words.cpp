// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_words.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/text/number_text.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace gpr::app {

namespace {

constexpr const char* dataGroup = "Files, regions and values of the input";

CommandOption textOption(const char* option, const char* argument, const char* help,
						 std::string& kept, const char* group)
{
	return {option, argument, help, [&kept](const std::string& word) { kept = word; }, group};
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

bool isMesh(const std::string& word)
{
	try {
		formatOfPath(word);
		return true;
	}
	catch (const AppError&) {
		return false;
	}
}

} // namespace

const char* const remeshDescription =
	"Remeshes IN with nearly equilateral triangles of equal size and writes OUT. The\n"
	"size is one of --vertices, --faces, --percent, --edge-length, --max-error and\n"
	"--detail, by default 10 % of the vertices of IN.";

std::string inHelp()
{
	return "Mesh to read: " + formatNames();
}

std::string outHelp()
{
	return "Mesh to write: " + formatNames() + "; may be IN";
}

std::string outHelpOfRemesh()
{
	return outHelp() + ".\nWith --out-dir another input mesh";
}

const std::vector<std::string> commandNames = {"remesh",   "levels",  "info",
											   "features", "compare", "tile"};

std::vector<std::string> withCommand(std::vector<std::string> words)
{
	const bool isCommand = !words.empty() && std::find(commandNames.begin(), commandNames.end(),
													   words.front()) != commandNames.end();
	if (!words.empty() && !isCommand && words.front()[0] != '-' && isMesh(words.front()))
		words.insert(words.begin(), "remesh");
	return words;
}

CommandOption RemeshWords::outputOption()
{
	return textOption("-o,--output", "OUT", "OUT, if the word behind IN is missing", line_.output,
					  everydayGroup);
}

CommandOption RemeshWords::outDirOption()
{
	return textOption(
		"--out-dir", "DIR",
		"Remesh all input meshes together and write each result into the folder DIR,\n"
		"with the name of the input. Borders of two files that coincide in the input also\n"
		"coincide in the results. A number of vertices or faces counts all files together",
		folder_, dataGroup);
}

CommandOption RemeshWords::transferOption()
{
	const auto take = [this](const std::string& word) {
		if (word != "mean" && word != "nearest")
			failUsage("--transfer takes mean or nearest, not '" + word + "'.");
		line_.transfer = word == "mean" ? Transfer::Mean : Transfer::Nearest;
	};
	return {
		"--transfer", "mean|nearest",
		"Values of the result's vertices: mean of the corners of the input face at the\n"
		"vertex, or value of the nearest corner. Default: nearest for labels (whole numbers) and\n"
		"for palette colours, mean for all other values",
		take, dataGroup};
}

CommandOption RemeshWords::periodicOption()
{
	return {"--periodic", "X,Y,Z",
			"IN is a periodic cell with these lengths, 0 along an axis without a period. The\n"
			"vertices of opposite borders are one period apart. Implies --boundary match.\n"
			"Refused if the opposite borders of IN are not one period apart",
			[this](const std::string& word) { line_.period = parsePeriod(word); }, dataGroup};
}

std::vector<CommandOption> RemeshWords::options()
{
	std::vector<CommandOption> all = {
		outputOption(), reportOption(line_, "Write a report of the run and the result as JSON"),
		quietOption(line_)};
	for (CommandOption& row : tableOptions(RemeshTool, given_))
		all.push_back(std::move(row));
	all.push_back(outDirOption());
	all.push_back(textOption(
		"--regions", "NAME|off",
		"Property of the faces of IN with the labels of regions. Region borders are kept\n"
		"as feature lines, and the result gets the labels. Default: region, label,\n"
		"material, group, CellEntityIds or material_index; groups and materials of OBJ\n"
		"files, solids of STL files. off: no regions",
		line_.regions, dataGroup));
	all.push_back(transferOption());
	all.push_back(textOption(
		"--sizes", "NAME",
		"Property of the vertices of IN with the wanted edge lengths, in mesh units. The\n"
		"lengths decide the number of vertices; a number of vertices or another size\n"
		"scales all lengths by one factor",
		line_.sizes, dataGroup));
	all.push_back(periodicOption());
	all.push_back(memoryOption(line_));
	all.push_back(textOption(
		"--scratch", "DIR",
		"With --memory: the folder for intermediate files, OUT.tiles by default. After an\n"
		"interrupted run the folder stays, and the same command continues the run",
		line_.tiles.folder, largeMeshGroup));
	all.push_back(tilesOutOption(line_));
	return all;
}

void RemeshWords::takeFiles(const std::vector<std::string>& files)
{
	files_ = files;
}

/// Assigns IN and OUT, or with --out-dir any number of IN.
void RemeshWords::sortFiles(CommandLine& line) const
{
	if (files_.empty()) failUsage("IN is required. See gpremesh --help.");
	line.input = files_.front();
	if (!folder_.empty()) {
		if (!line.output.empty()) failUsage("give only one of --output and --out-dir.");
		line.pieces = files_;
		line.output = withoutSlashAtEnd(folder_);
		return;
	}
	std::vector<std::string> outputs(files_.begin() + 1, files_.end());
	if (!line.output.empty()) outputs.push_back(line.output);
	if (outputs.empty()) failUsage("OUT is required.");
	if (files_.size() > 2) failUsage("More than two files need --out-dir.");
	if (outputs.size() > 1) failUsage("OUT is given twice, behind IN and by --output.");
	line.output = outputs.front();
}

CommandLine RemeshWords::line() const
{
	CommandLine line = line_;
	line.command     = Command::Remesh;
	sortFiles(line);
	complete(given_, line);
	return line;
}

} // namespace gpr::app
