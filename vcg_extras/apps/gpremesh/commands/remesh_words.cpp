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

[[noreturn]] void failUsage(const std::string& sentence)
{
	throw AppError(ExitCode::Usage, sentence);
}

CommandOption textOption(const char* option, const char* argument, const char* help,
						 std::string& kept)
{
	return {option, argument, help, [&kept](const std::string& word) { kept = word; }};
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
		failUsage("--periodic takes three numbers with commas between, not '" + word + "'.");
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
	"Remeshes IN with about-equilateral triangles of equal size and writes OUT.\n"
	"The size is given by one of --vertices, --faces, --percent and --edge-length;\n"
	"10 % of IN's vertices where none is given.";
const char* const inHelp = "Mesh to read: .ply, .obj, .off, .stl or .glb";
const char* const outHelp =
	"Mesh to write: .ply, .obj, .off, .stl or .glb; may be IN. With --out-dir\n"
	"another IN, as all that follow";

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
	return textOption("-o,--output", "OUT", "OUT, where it does not stand behind IN", line_.output);
}

CommandOption RemeshWords::outDirOption()
{
	return textOption(
		"--out-dir", "DIR",
		"Remesh all IN together and write each into the folder DIR, under its name.\n"
		"Where borders of the files coincide, they do so in the result, too. A number\n"
		"of vertices or faces is that of all of them together",
		folder_);
}

CommandOption RemeshWords::transferOption()
{
	const auto take = [this](const std::string& word) {
		if (word != "mean" && word != "nearest")
			failUsage("--transfer takes one of mean, nearest, not '" + word + "'.");
		line_.transfer = word == "mean" ? Transfer::Mean : Transfer::Nearest;
	};
	return {"--transfer", "mean|nearest",
			"How values of vertices come to the result: mean over the corners round each\n"
			"place, or the nearest corner's. If not given: the mean, but the nearest of\n"
			"labels (whole numbers) and of colours that are a palette",
			take};
}

CommandOption RemeshWords::periodicOption()
{
	return {"--periodic", "X,Y,Z",
			"IN is a periodic cell with these lengths, 0 along an axis without a period:\n"
			"vertices at opposite borders match after adding the length. Implies\n"
			"--boundary match. Refused where the borders are no translates",
			[this](const std::string& word) { line_.period = parsePeriod(word); }};
}

std::vector<CommandOption> RemeshWords::options()
{
	std::vector<CommandOption> all = {outputOption(), outDirOption()};
	for (CommandOption& row : tableOptions(RemeshTool, given_))
		all.push_back(std::move(row));
	all.push_back(
		textOption("--regions", "NAME|off",
				   "The property of IN's faces that tells their regions, whose borders are kept\n"
				   "as lines and whose labels the result gets. If not given: region, label,\n"
				   "material, group, CellEntityIds and material_index, groups and materials of\n"
				   "OBJ, solids of STL. off: none",
				   line_.regions));
	all.push_back(transferOption());
	all.push_back(
		textOption("--sizes", "NAME",
				   "Vertex property of IN that holds the edge lengths wanted there, in mesh\n"
				   "units. With them alone the number of vertices follows; with a number of\n"
				   "vertices or another size they are scaled to it",
				   line_.sizes));
	all.push_back(periodicOption());
	all.push_back(reportOption(line_, "Write what was done, and how well, as JSON"));
	all.push_back(quietOption(line_));
	all.push_back(memoryOption(line_));
	all.push_back(
		textOption("--scratch", "DIR",
				   "With --memory: the folder for what is put aside, OUT.tiles by default. It is\n"
				   "kept where the run ends early, which then goes on there when run again",
				   line_.tiles.folder));
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
