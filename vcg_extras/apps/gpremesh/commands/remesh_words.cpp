// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_words.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>

namespace gpr::app {

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

Command commandNamed(const std::string& word)
{
	const auto name = std::find(commandNames.begin(), commandNames.end(), word);
	return Command(name - commandNames.begin());
}

std::vector<std::string> withCommand(std::vector<std::string> words)
{
	const bool isOther = !words.empty() && commandNamed(words.front()) == Command::None;
	if (isOther && words.front()[0] != '-' && isMeshName(words.front()))
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

std::vector<CommandOption> RemeshWords::options()
{
	std::vector<CommandOption> all = {
		outputOption(), reportOption(line_, "Write a report of the run and the result as JSON"),
		quietOption(line_)};
	for (CommandOption& row : tableOptions(RemeshTool, given_))
		all.push_back(std::move(row));
	all.push_back(outDirOption());
	for (CommandOption& row : valueOptions(line_))
		all.push_back(std::move(row));
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
