// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include "manual_page.h"
#include "remesh_command.h"
#include "table_options.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/text/number_text.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>

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
	std::vector<std::string> files = {line.input, line.output};
	for (const std::string& piece : line.pieces)
		files.insert(files.end(), {piece, pathOfPiece(line, piece)});
	for (std::size_t i = 0; i < line.levels.sizes.size(); ++i)
		files.push_back(pathOfLevel(line.output, i + 1));
	for (const std::string& file : files) {
		if (sameFile(line.report, file))
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

/// OUT must have a place for the number of the level, and sizes must be what they stand for.
void checkLevels(const CommandLine& line)
{
	const LevelSizes& levels = line.levels;
	if (levels.sizes.empty()) failUsage("levels needs one of --percent, --vertices and --faces.");
	if (line.output.find(levelPlace) == std::string::npos)
		failUsage("OUT must have {level} in its name, such as small_{level}.ply.");
	const double most = levels.mode == TargetMode::Percent ? 10000 : 2147483647.0;
	for (const double size : levels.sizes) {
		const bool isWhole = levels.mode == TargetMode::Percent || size == std::floor(size);
		if (!isWhole || size > most)
			failUsage("the sizes of levels are percentages up to 10000, or whole numbers.");
	}
	formatOfPath(line.output);
	checkReport(line);
}

void checkPaths(const CommandLine& line)
{
	if (line.command == Command::Tile) return;
	if (!line.pieces.empty()) return checkPieces(line);
	formatOfPath(line.input);
	if (line.command == Command::Levels) return checkLevels(line);
	if (line.command != Command::Remesh && line.command != Command::Features) return;
	if (line.outTileNum > 0) return checkReport(line);
	const MeshFormat written = formatOfPath(line.output);
	if (line.command == Command::Features && written != MeshFormat::Ply) {
		failUsage("features writes .ply only, the one format here that holds quality and colour.");
	}
	checkReport(line);
}

/// The parser's complaint with a full stop.
std::string sentence(std::string complaint)
{
	if (!complaint.empty() && complaint.back() != '.') complaint += '.';
	return complaint;
}

void addOutcome(CLI::App& command, CommandLine& line, const char* reportHelp)
{
	command.add_option("--report", line.report, reportHelp)->type_name("FILE.json");
	command.add_flag("--quiet", line.quiet, "No progress and no summary; errors are told still");
}

void addOutput(CLI::App& command, CommandLine& line)
{
	command
		.add_option("OUT", line.output, "Mesh to write: .ply, .obj, .off, .stl or .glb; may be IN")
		->required();
}

void addTilesOut(CLI::App& command, CommandLine& line)
{
	command
		.add_option("--tiles-out", line.outTileNum,
					"Write OUT as a folder of T binary PLY files whose borders coincide, and of\n"
					"tiles.json, which tells the box of each")
		->check(CLI::Range(1, 10000))
		->type_name("T");
}

void addMemory(CLI::App& command, CommandLine& line)
{
	command
		.add_option("--memory", line.tiles.memoryBytes,
					"Memory to use at most, about, such as 8G. A larger mesh is read in tiles,\n"
					"each condensed by itself; the result is made of all of them together")
		->transform(CLI::AsSizeValue(true))
		->type_name("SIZE");
}

/// What follows IN and OUT.
struct Files {
	std::vector<std::string> more;
	std::string              folder;
};

/// IN and OUT, or with --out-dir any number of IN.
void addFiles(CLI::App& remesh, CommandLine& line, Files& files)
{
	remesh.add_option("IN", line.input, "Mesh to read: .ply, .obj, .off, .stl or .glb")->required();
	remesh.add_option("OUT", line.output,
					  "Mesh to write: .ply, .obj, .off, .stl or .glb; may be IN. With --out-dir\n"
					  "another IN, as all that follow");
	remesh.add_option("MORE", files.more, "With --out-dir: more IN");
	remesh
		.add_option("--out-dir", files.folder,
					"Remesh all IN together and write each into the folder DIR, under its name.\n"
					"Where borders of the files coincide, they do so in the result, too. A number\n"
					"of vertices or faces is that of all of them together")
		->type_name("DIR");
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

CLI::App* addRemesh(CLI::App& app, CommandLine& line, GivenOptions& given, Files& files)
{
	CLI::App* remesh = app.add_subcommand(
		"remesh", "Remeshes IN with about-equilateral triangles of equal size and writes OUT.\n"
				  "The size is given by one of --vertices, --faces, --percent and --edge-length;\n"
				  "10 % of IN's vertices where none is given.");
	addFiles(*remesh, line, files);
	addTableOptions(*remesh, RemeshTool, given);
	remesh
		->add_option("--regions", line.regions,
					 "The property of IN's faces that tells their regions, whose borders are kept\n"
					 "as lines and whose labels the result gets. If not given: region, label,\n"
					 "material, group, CellEntityIds and material_index, groups and materials of\n"
					 "OBJ, solids of STL. off: none")
		->type_name("NAME|off");
	remesh
		->add_option("--transfer", line.transfer,
					 "How values of vertices come to the result: mean over the corners round each\n"
					 "place, or the nearest corner's. If not given: the mean, but the nearest of\n"
					 "labels (whole numbers) and of colours that are a palette")
		->transform(
			CLI::CheckedTransformer(std::map<std::string, Transfer>{{"mean", Transfer::Mean},
																	{"nearest", Transfer::Nearest}})
				.description(""))
		->type_name("mean|nearest");
	remesh
		->add_option("--sizes", line.sizes,
					 "Vertex property of IN that holds the edge lengths wanted there, in mesh\n"
					 "units. With them alone the number of vertices follows; with a number of\n"
					 "vertices or another size they are scaled to it")
		->type_name("NAME");
	remesh
		->add_option("--periodic", line.period,
					 "IN is a periodic cell with these lengths, 0 along an axis without a period:\n"
					 "vertices at opposite borders match after adding the length. Implies\n"
					 "--boundary match. Refused where the borders are no translates")
		->delimiter(',')
		->expected(3)
		->allow_extra_args(false)
		->type_name("X,Y,Z");
	addOutcome(*remesh, line, "Write what was done, and how well, as JSON");
	addMemory(*remesh, line);
	remesh
		->add_option(
			"--scratch", line.tiles.folder,
			"With --memory: the folder for what is put aside, OUT.tiles by default. It is\n"
			"kept where the run ends early, which then goes on there when run again")
		->type_name("DIR");
	addTilesOut(*remesh, line);
	remesh->footer(exitCodeHelp);
	return remesh;
}

bool isForLevels(const Parameter& p)
{
	return !isSizeParameter(p) && std::string(p.key) != "Check";
}

void addLevelSizes(CLI::App& levels, const char* option, const char* help, TargetMode mode,
				   CommandLine& line)
{
	const auto keep = [&line, mode, option](const std::string& text) {
		if (!line.levels.sizes.empty())
			failUsage("give only one of --percent, --vertices and --faces.");
		line.levels.mode = mode;
		std::istringstream parts(text);
		for (std::string part; std::getline(parts, part, ',');) {
			double size = 0;
			if (!parseNumber(part, size) || !(size > 0))
				failUsage(std::string(option) +
						  " takes numbers above 0 with commas between, not '" + text + "'.");
			line.levels.sizes.push_back(size);
		}
	};
	levels.add_option_function<std::string>(option, keep, help)->type_name("N,N,...");
}

/// Several sizes of one mesh.
CLI::App* addLevels(CLI::App& app, CommandLine& line, GivenOptions& given)
{
	CLI::App* levels = app.add_subcommand(
		"levels",
		"Remeshes IN to several sizes, such as levels of detail, and writes a file each.\n"
		"IN is read and prepared once. Each level tells how far it is from IN at most,\n"
		"which is proven.");
	levels->add_option("IN", line.input, "Mesh to read: .ply, .obj, .off, .stl or .glb")
		->required();
	levels
		->add_option("OUT", line.output,
					 "Files to write, with {level} for the number of the level from 1 on, such as\n"
					 "small_{level}.ply")
		->required();
	addLevelSizes(*levels, "--percent", "Sizes in percent of IN's vertices, such as 50,25,10,5",
				  TargetMode::Percent, line);
	addLevelSizes(*levels, "--vertices", "Sizes as numbers of vertices", TargetMode::VertexNum,
				  line);
	addLevelSizes(*levels, "--faces", "Sizes as numbers of faces", TargetMode::FaceNum, line);
	addTableOptions(*levels, RemeshTool, given, isForLevels);
	addOutcome(*levels, line,
			   "Write what was done, and how well, as JSON: 'levels' has a report each");
	levels->footer(exitCodeHelp);
	return levels;
}

CLI::App* addInfo(CLI::App& app, CommandLine& line)
{
	CLI::App* info = app.add_subcommand("info", "Prints counts, topology and quality of IN.");
	info->add_option("IN", line.input, "Mesh to read: .ply, .obj, .off, .stl or .glb")->required();
	info->add_flag("--json", line.json, "Print JSON");
	info->footer(exitCodeHelp);
	return info;
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

CLI::App* addCompare(CLI::App& app, CommandLine& line, GivenOptions& given)
{
	CLI::App* compare = app.add_subcommand(
		"compare",
		"Remeshes IN with these options, by the paper's preset and by MeshLab's Quadric\n"
		"Edge Collapse and prints a table: time, distances from IN, triangle quality.");
	compare->add_option("IN", line.input, "Mesh to read: .ply, .obj, .off, .stl or .glb")
		->required();
	addTableOptions(*compare, RemeshTool, given, isForCompare);
	compare->add_flag("--isotropic", line.isotropic, "MeshLab's Isotropic Explicit Remeshing too");
	compare->add_option("--runs", line.runNum, "How often each method is run; the median counts")
		->check(CLI::Range(1, 101))
		->type_name("K");
	compare->add_flag("--json", line.json, "Print JSON");
	compare
		->add_option("--html", line.htmlFolder,
					 "Write the page DIR/index.html with views to turn and pictures")
		->type_name("DIR");
	compare->footer(exitCodeHelp);
	return compare;
}

CLI::App* addFeatures(CLI::App& app, CommandLine& line, GivenOptions& given)
{
	CLI::App* features = app.add_subcommand(
		"features",
		"Finds creases and cone apexes of IN and writes OUT: the same mesh with the strength of\n"
		"its vertices, in degrees, as quality and colour, features selected.");
	features->add_option("IN", line.input, "Mesh to read: .ply, .obj, .off, .stl or .glb")
		->required();
	features->add_option("OUT", line.output, "Mesh to write, may be IN: .ply")->required();
	addTableOptions(*features, FeatureTool, given);
	addOutcome(*features, line, "Write thresholds and counts as JSON");
	features->footer(exitCodeHelp);
	return features;
}

CLI::App* addTileStep(CLI::App& tile, CommandLine& line, TileStep step, const char* name,
					  const char* help)
{
	CLI::App* const command = tile.add_subcommand(name, help);
	command->add_option("DIR", line.tiles.folder, "The folder of the run")->required();
	command->callback([&line, step] { line.tiles.step = step; });
	return command;
}

/// The steps of a run in tiles, for several machines that share a folder.
CLI::App* addTile(CLI::App& app, CommandLine& line, GivenOptions& given)
{
	CLI::App* const tile = app.add_subcommand(
		"tile",
		"The steps of a run in tiles, for many machines that share the folder DIR: plan,\n"
		"split, part for every tile, join, finish. A step that was done is not done again.");
	tile->require_subcommand(1);
	CLI::App* const plan = addTileStep(*tile, line, TileStep::Plan, "plan",
									   "Decides how IN is cut. Reads a sample of a binary "
									   "PLY\nfile; of others such a file is made first.");
	plan->add_option("IN", line.tiles.inputs,
					 "PLY, OBJ, OFF or binary STL files, pieces of one surface")
		->required();
	addTableOptions(*plan, RemeshTool, given, isForPlan);
	addMemory(*plan, line);
	plan->add_option("--tiles", line.tiles.tileNum, "How many; by the memory if not given")
		->check(CLI::Range(1, 10000))
		->type_name("T");
	addTileStep(*tile, line, TileStep::Split, "split", "Reads IN once and cuts it into tiles.");
	CLI::App* const part = addTileStep(*tile, line, TileStep::Part, "part", "Condenses one tile.");
	part->add_option("--unit", line.tiles.unit, "Number of the tile, from 0")->required();
	addTableOptions(*part, RemeshTool, given, isForStep);
	addTileStep(*tile, line, TileStep::Join, "join", "Puts the condensed tiles together.");
	CLI::App* const finish =
		addTileStep(*tile, line, TileStep::Finish, "finish", "Remeshes what was joined.");
	addOutput(*finish, line);
	addTableOptions(*finish, RemeshTool, given, isForStep);
	addOutcome(*finish, line, "Write what was done, and how well, as JSON");
	addTilesOut(*finish, line);
	tile->footer(exitCodeHelp);
	return tile;
}

/// For the build, which installs the page; --help does not show it.
void addManualPage(CLI::App& app)
{
	const auto print = [&app] {
		std::fputs(manualPage(app).c_str(), stdout);
		throw CLI::Success();
	};
	app.add_flag_callback("--manual-page", print)->group("");
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
	CLI::App     app("Remeshes triangle meshes by geodesic Poisson-disk sampling.", "gpremesh");
	app.set_version_flag("--version", std::string("gpremesh ") + GPR_VERSION);
	app.require_subcommand(1);
	app.allow_windows_style_options(false); // a path may begin with '/' everywhere
	app.footer("'gpremesh COMMAND --help' tells the options of a command.\n\n" +
			   std::string(exitCodeHelp));
	CLI::App* const remesh   = addRemesh(app, line, given, files);
	CLI::App* const info     = addInfo(app, line);
	CLI::App* const compare  = addCompare(app, line, given);
	CLI::App* const features = addFeatures(app, line, given);
	CLI::App* const tile     = addTile(app, line, given);
	CLI::App* const levels   = addLevels(app, line, given);
	addManualPage(app);
	try {
		app.parse(argc, argv);
	}
	catch (const CLI::Success& wish) { // --help, --version and --manual-page
		app.exit(wish);
		return line;
	}
	catch (const CLI::ParseError& error) {
		failUsage(sentence(error.what()) + " See gpremesh --help.");
	}
	if (remesh->parsed()) {
		line.command = Command::Remesh;
		takeFiles(files, line);
	}
	if (info->parsed()) line.command = Command::Info;
	if (compare->parsed()) line.command = Command::Compare;
	if (features->parsed()) line.command = Command::Features;
	if (tile->parsed()) line.command = Command::Tile;
	if (levels->parsed()) line.command = Command::Levels;
	line.options = optionsOf(given);
	if (!line.sizes.empty()) {
		const bool isSized = std::any_of(given.begin(), given.end(), [](const auto& g) {
			return choosesSize(*g.first, g.second);
		});
		if (!isSized) line.options.targetMode = TargetMode::Sizes;
		if (line.tiles.memoryBytes > 0) failUsage("--sizes is not possible in tiles.");
	}
	takePeriod(line);
	const bool isTiled = line.tiles.memoryBytes > 0 || line.command == Command::Tile;
	if (isTiled && line.options.symmetry != Symmetry::Off)
		failUsage("--symmetry is not possible in tiles.");
	line.optionsText       = textOf(given);
	line.tiles.optionsText = textOf(given, isForPlan);
	if (line.outTileNum > 0) line.output = withoutSlashAtEnd(line.output);
	checkPaths(line);
	return line;
}

} // namespace gpr::app
