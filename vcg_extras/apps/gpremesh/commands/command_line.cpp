// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include "argument_parser.h"
#include "manual_page.h"
#include "table_options.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <climits>
#include <cstdio>
#include <filesystem>
#include <set>

namespace gpr::app {

namespace {

const char* const exitCodeHelp =
	"Exit codes:\n"
	"  0  done\n"
	"  1  failed for a reason not listed here: no memory, OUT not writable, ...\n"
	"  2  the command line is wrong\n"
	"  3  IN cannot be read or holds no usable surface\n"
	"  4  a promise could not be kept, such as a number of vertices below what\n"
	"     the topology needs; nothing is written\n"
	"  5  cancelled or out of time; nothing is written\n";

[[noreturn]] void failUsage(const std::string& sentence)
{
	throw AppError(ExitCode::Usage, sentence);
}

bool sameFile(const std::string& a, const std::string& b)
{
	std::error_code error;
	return std::filesystem::weakly_canonical(a, error) ==
		   std::filesystem::weakly_canonical(b, error);
}

/// "tiles/" is "tiles".
std::string withoutSlashAtEnd(const std::string& path)
{
	const std::filesystem::path all(path);
	return all.has_filename() ? path : all.parent_path().string();
}

void checkReport(const CommandLine& line)
{
	if (line.report.empty()) return;
	if (sameFile(line.report, line.output) || sameFile(line.report, line.input)) {
		failUsage("--report must name another file than IN and OUT.");
	}
}

void checkPieces(const CommandLine& line)
{
	std::set<std::string> names;
	for (const std::string& piece : line.pieces) {
		formatOfPath(piece);
		if (!names.insert(pathOfPiece(line, piece)).second)
			failUsage("Two of the files have the same name; DIR has place for one of them.");
	}
	if (line.options.selectedOnly) failUsage("--selected is for one file only.");
	if (!line.options.sew)
		failUsage(
			"Several files are joined where their borders coincide; --sew off is not for them.");
	if (line.outTileNum > 0 || line.tiles.memoryBytes > 0)
		failUsage("Tiles are made of one file only.");
	checkReport(line);
}

void checkPaths(const CommandLine& line)
{
	if (line.command == Command::Tile) return;
	if (!line.pieces.empty()) return checkPieces(line);
	formatOfPath(line.input);
	if (line.command != Command::Remesh && line.command != Command::Features) return;
	if (line.outTileNum > 0) return checkReport(line);
	const MeshFormat written = formatOfPath(line.output);
	if (line.command == Command::Features && written != MeshFormat::Ply) {
		failUsage("features writes .ply only, the one format here that holds quality and colour.");
	}
	checkReport(line);
}

std::function<void()> keepTrue(bool& flag)
{
	return [&flag] { flag = true; };
}

void addInput(CommandSpec& command, CommandLine& line)
{
	command.addPositional("IN", "Mesh to read: .ply, .obj, .off, .stl or .glb",
						  keepText(line.input));
}

void addOutput(CommandSpec& command, CommandLine& line)
{
	command.addPositional("OUT", "Mesh to write: .ply, .obj, .off, .stl or .glb; may be IN",
						  keepText(line.output));
}

void addOutcome(CommandSpec& command, CommandLine& line, const char* reportHelp)
{
	command.addOption("--report", "FILE.json", reportHelp, keepText(line.report));
	command.addFlag("--quiet", "No progress and no summary; errors are told still",
					keepTrue(line.quiet));
}

void addTilesOut(CommandSpec& command, CommandLine& line)
{
	command.addOption("--tiles-out", "T",
					  "Write OUT as a folder of T binary PLY files whose borders coincide, and of\n"
					  "tiles.json, which tells the box of each. T is from 1 to 10000",
					  keepWhole("--tiles-out", line.outTileNum, 1, 10000));
}

void addMemory(CommandSpec& command, CommandLine& line)
{
	command.addOption("--memory", "SIZE",
					  "Memory to use at most, about, such as 8G. A larger mesh is read in tiles,\n"
					  "each condensed by itself; the result is made of all of them together",
					  keepBytes("--memory", line.tiles.memoryBytes));
}

Transfer transferOf(const std::string& word)
{
	if (word == "mean") return Transfer::Mean;
	if (word == "nearest") return Transfer::Nearest;
	failUsage("--transfer takes one of mean, nearest, not '" + word + "'.");
}

/// What of the file's data the result follows or gets.
void addDataOptions(CommandSpec& remesh, CommandLine& line)
{
	remesh.addOption("--regions", "NAME|off",
					 "The property of IN's faces that tells their regions, whose borders are kept\n"
					 "as lines and whose labels the result gets. If not given: region, label,\n"
					 "material, group, CellEntityIds and material_index, groups and materials of\n"
					 "OBJ, solids of STL. off: none",
					 keepText(line.regions));
	remesh.addOption("--transfer", "mean|nearest",
					 "How values of vertices come to the result: mean over the corners round each\n"
					 "place, or the nearest corner's. If not given: the mean, but the nearest of\n"
					 "labels (whole numbers) and of colours that are a palette",
					 [&line](const std::string& word) { line.transfer = transferOf(word); });
	remesh.addOption("--sizes", "NAME",
					 "Vertex property of IN that holds the edge lengths wanted there, in mesh\n"
					 "units. With them alone the number of vertices follows; with a number of\n"
					 "vertices or another size they are scaled to it",
					 keepText(line.sizes));
	remesh.addOption("--periodic", "X,Y,Z",
					 "IN is a periodic cell with these lengths, 0 along an axis without a period:\n"
					 "vertices at opposite borders match after adding the length. Implies\n"
					 "--boundary match. Refused where the borders are no translates",
					 keepNumbers("--periodic", line.period, 3));
}

/// What follows IN and OUT.
struct Files {
	std::vector<std::string> more;
	std::string              folder;
};

/// IN and OUT, or with --out-dir any number of IN.
void addFiles(CommandSpec& remesh, CommandLine& line, Files& files)
{
	addInput(remesh, line);
	remesh
		.addPositional("OUT",
					   "Mesh to write: .ply, .obj, .off, .stl or .glb; may be IN. With --out-dir\n"
					   "another IN, as all that follow",
					   keepText(line.output))
		.isRequired = false;
	Argument& more =
		remesh.addPositional("MORE", "With --out-dir: more IN", keepEachText(files.more));
	more.isRequired = false;
	more.takesMany  = true;
	remesh.addOption(
		"--out-dir", "DIR",
		"Remesh all IN together and write each into the folder DIR, under its name.\n"
		"Where borders of the files coincide, they do so in the result, too. A number\n"
		"of vertices or faces is that of all of them together",
		keepText(files.folder));
}

/// Sorts what addFiles has read.
void takeFiles(const Files& files, CommandLine& line)
{
	if (files.folder.empty()) {
		if (line.output.empty()) failUsage("OUT is required.");
		if (!files.more.empty()) failUsage("More than two files need --out-dir.");
		return;
	}
	line.pieces = {line.input};
	if (!line.output.empty()) line.pieces.push_back(line.output);
	line.pieces.insert(line.pieces.end(), files.more.begin(), files.more.end());
	line.output = withoutSlashAtEnd(files.folder);
}

void addRemesh(CommandSpec& program, CommandLine& line, GivenOptions& given, Files& files)
{
	CommandSpec& remesh = program.addCommand(
		"remesh", "Remeshes IN with about-equilateral triangles of equal size and writes OUT.\n"
				  "The size is given by one of --vertices, --faces, --percent and --edge-length;\n"
				  "10 % of IN's vertices where none is given.");
	remesh.chosen = [&line] { line.command = Command::Remesh; };
	addFiles(remesh, line, files);
	addTableOptions(remesh, RemeshTool, given);
	addDataOptions(remesh, line);
	addOutcome(remesh, line, "Write what was done, and how well, as JSON");
	addMemory(remesh, line);
	remesh.addOption(
		"--scratch", "DIR",
		"With --memory: the folder for what is put aside, OUT.tiles by default. It is\n"
		"kept where the run ends early, which then goes on there when run again",
		keepText(line.tiles.folder));
	addTilesOut(remesh, line);
	remesh.footer = exitCodeHelp;
}

void addInfo(CommandSpec& program, CommandLine& line)
{
	CommandSpec& info = program.addCommand("info", "Prints counts, topology and quality of IN.");
	info.chosen       = [&line] { line.command = Command::Info; };
	addInput(info, line);
	info.addFlag("--json", "Print JSON", keepTrue(line.json));
	info.footer = exitCodeHelp;
}

/// A plan does not depend on what each run of a step has.
bool isForPlan(const Parameter& p)
{
	return std::string(p.key) != "TimeLimit" && std::string(p.key) != "Threads";
}

bool isForStep(const Parameter& p)
{
	return !isForPlan(p);
}

/// The other methods know no time limit and remesh the whole; all results are checked.
bool isForCompare(const Parameter& p)
{
	const std::string key = p.key;
	return key != "TimeLimit" && key != "Selected" && key != "Check";
}

void addCompare(CommandSpec& program, CommandLine& line, GivenOptions& given)
{
	CommandSpec& compare = program.addCommand(
		"compare",
		"Remeshes IN with these options, by the paper's preset and by MeshLab's Quadric\n"
		"Edge Collapse and prints a table: time, distances from IN, triangle quality.");
	compare.chosen = [&line] { line.command = Command::Compare; };
	addInput(compare, line);
	addTableOptions(compare, RemeshTool, given, isForCompare);
	compare.addFlag("--isotropic", "MeshLab's Isotropic Explicit Remeshing too",
					keepTrue(line.isotropic));
	compare.addOption("--runs", "K", "How often each method is run, 1 to 101; the median counts",
					  keepWhole("--runs", line.runNum, 1, 101));
	compare.addFlag("--json", "Print JSON", keepTrue(line.json));
	compare.addOption("--html", "DIR",
					  "Write the page DIR/index.html with views to turn and pictures",
					  keepText(line.htmlFolder));
	compare.footer = exitCodeHelp;
}

void addFeatures(CommandSpec& program, CommandLine& line, GivenOptions& given)
{
	CommandSpec& features = program.addCommand(
		"features",
		"Finds creases and cone apexes of IN and writes OUT: the same mesh with the strength of\n"
		"its vertices, in degrees, as quality and colour, features selected.");
	features.chosen = [&line] { line.command = Command::Features; };
	addInput(features, line);
	features.addPositional("OUT", "Mesh to write, may be IN: .ply", keepText(line.output));
	addTableOptions(features, FeatureTool, given);
	addOutcome(features, line, "Write thresholds and counts as JSON");
	features.footer = exitCodeHelp;
}

CommandSpec& addTileStep(CommandSpec& tile, CommandLine& line, TileStep step, const char* name,
						 const char* help)
{
	CommandSpec& command = tile.addCommand(name, help);
	command.addPositional("DIR", "The folder of the run", keepText(line.tiles.folder));
	command.chosen = [&line, step] { line.tiles.step = step; };
	return command;
}

void addTilePlan(CommandSpec& tile, CommandLine& line, GivenOptions& given)
{
	CommandSpec& plan = addTileStep(tile, line, TileStep::Plan, "plan",
									"Decides how IN is cut. Reads a sample of a binary PLY\n"
									"file; of others such a file is made first.");
	plan.addPositional("IN", "PLY, OBJ, OFF or binary STL files, pieces of one surface",
					   keepEachText(line.tiles.inputs))
		.takesMany = true;
	addTableOptions(plan, RemeshTool, given, isForPlan);
	addMemory(plan, line);
	plan.addOption("--tiles", "T", "How many, 1 to 10000; by the memory if not given",
				   keepWhole("--tiles", line.tiles.tileNum, 1, 10000));
}

/// The steps of a run in tiles, for several machines that share a folder.
void addTile(CommandSpec& program, CommandLine& line, GivenOptions& given)
{
	CommandSpec& tile = program.addCommand(
		"tile",
		"The steps of a run in tiles, for many machines that share the folder DIR: plan,\n"
		"split, part for every tile, join, finish. A step that was done is not done again.");
	tile.chosen = [&line] { line.command = Command::Tile; };
	addTilePlan(tile, line, given);
	addTileStep(tile, line, TileStep::Split, "split", "Reads IN once and cuts it into tiles.");
	CommandSpec& part = addTileStep(tile, line, TileStep::Part, "part", "Condenses one tile.");
	part.addOption("--unit", "U", "Number of the tile, from 0",
				   keepWhole("--unit", line.tiles.unit, 0, INT_MAX))
		.isRequired = true;
	addTableOptions(part, RemeshTool, given, isForStep);
	addTileStep(tile, line, TileStep::Join, "join", "Puts the condensed tiles together.");
	CommandSpec& finish =
		addTileStep(tile, line, TileStep::Finish, "finish", "Remeshes what was joined.");
	addOutput(finish, line);
	addTableOptions(finish, RemeshTool, given, isForStep);
	addOutcome(finish, line, "Write what was done, and how well, as JSON");
	addTilesOut(finish, line);
	tile.footer = exitCodeHelp;
}

/// What the program tells of itself; the build installs the manual page, which --help does not
/// show.
void addAnswers(CommandSpec& program, std::string& answer)
{
	program.addFlag("--version", "Print the version and exit",
					[&answer] { answer = "gpremesh " GPR_VERSION "\n"; });
	program.addFlag("--manual-page", "", [&program, &answer] { answer = manualPage(program); });
	program.options.back().isHidden = true;
}

void takePeriod(CommandLine& line)
{
	if (line.period.empty()) return;
	if (line.tiles.memoryBytes > 0) failUsage("--periodic is not possible in tiles.");
	line.options.period = {line.period[0], line.period[1], line.period[2]};
	if (!isPeriodic(line.options)) failUsage("--periodic needs a length above 0.");
}

} // namespace

std::string pathOfPiece(const CommandLine& line, const std::string& piece)
{
	return (std::filesystem::path(line.output) / std::filesystem::path(piece).filename()).string();
}

CommandLine parseCommandLine(int argc, char** argv)
{
	CommandLine  line;
	Files        files;
	GivenOptions given; // by one command only: there is no second
	std::string  answer;
	CommandSpec  program("gpremesh", "Remeshes triangle meshes by geodesic Poisson-disk sampling.");
	program.footer =
		"'gpremesh COMMAND --help' tells the options of a command.\n\n" + std::string(exitCodeHelp);
	addAnswers(program, answer);
	addRemesh(program, line, given, files);
	addInfo(program, line);
	addCompare(program, line, given);
	addFeatures(program, line, given);
	addTile(program, line, given);
	const std::string help = parseArguments(program, {argv + 1, argv + argc});
	if (!help.empty() || !answer.empty()) {
		std::fputs((help.empty() ? answer : help).c_str(), stdout);
		line.command = Command::None;
		return line;
	}
	if (line.command == Command::Remesh) takeFiles(files, line);
	line.options = optionsOf(given);
	if (!line.sizes.empty()) {
		const bool isSized = std::any_of(given.begin(), given.end(), [](const auto& g) {
			return choosesSize(*g.first, g.second);
		});
		if (!isSized) line.options.targetMode = TargetMode::Sizes;
		if (line.tiles.memoryBytes > 0) failUsage("--sizes is not possible in tiles.");
	}
	takePeriod(line);
	line.optionsText       = textOf(given);
	line.tiles.optionsText = textOf(given, isForPlan);
	if (line.outTileNum > 0) line.output = withoutSlashAtEnd(line.output);
	checkPaths(line);
	return line;
}

} // namespace gpr::app
