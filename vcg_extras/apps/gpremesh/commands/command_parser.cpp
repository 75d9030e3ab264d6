// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_parser.h"

#include "command_option.h"
#include "commands.h"
#include "manual_page.h"
#include "remesh_words.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/text/number_text.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <sstream>

namespace gpr::app {

namespace {

const char* const exitCodeHelp =
	"Exit codes:\n"
	"  0  done\n"
	"  1  any other failure: no memory, OUT not writable, ...\n"
	"  2  the command line is wrong\n"
	"  3  IN cannot be read or holds no usable surface\n"
	"  4  a promise could not be kept, such as a number of vertices too small for\n"
	"     the topology; nothing is written\n"
	"  5  cancelled or out of time; nothing is written\n";

/// The parser's complaint with a full stop.
std::string sentence(std::string complaint)
{
	if (!complaint.empty() && complaint.back() != '.') complaint += '.';
	return complaint;
}

/// --help with the everyday options only, if a command has further groups; --help-all has all
/// groups.
class GroupedHelp : public CLI::Formatter {
	using Options = std::vector<const CLI::Option*>;

	static Options everydayOptions(const CLI::App& command)
	{
		return command.get_options([](const CLI::Option* option) {
			return option->nonpositional() && option->get_group() == everydayGroup;
		});
	}

	static bool hasMore(const CLI::App& command)
	{
		return !command
					.get_options([](const CLI::Option* option) {
						return !option->get_group().empty() && option->get_group() != everydayGroup;
					})
					.empty();
	}

public:
	std::string make_help(const CLI::App* command, std::string name,
						  CLI::AppFormatMode mode) const override
	{
		if (mode != CLI::AppFormatMode::Normal || !hasMore(*command))
			return CLI::Formatter::make_help(command, name, mode);
		return make_description(command) + make_usage(command, name) + make_positionals(command) +
			   make_group(everydayGroup, false, everydayOptions(*command)) + "\n'" + name +
			   " --help-all' lists all options, in groups.\n\n" + make_footer(command);
	}
};

CLI::Option* add(CLI::App& command, const CommandOption& option)
{
	if (option.argument.empty())
		return command.add_flag_callback(
			option.option, [option] { option.take("on"); }, option.help);
	return command.add_option_function<std::string>(option.option, option.take, option.help)
		->type_name(option.argument);
}

/// For commands with many options.
void addInGroups(CLI::App& command, const std::vector<CommandOption>& options)
{
	for (const CommandOption& option : options)
		add(command, option)->group(option.group);
}

void addTableOptions(CLI::App& command, Tool tool, GivenOptions& given,
					 bool (*isWanted)(const Parameter&) = nullptr)
{
	for (const CommandOption& option : tableOptions(tool, given, isWanted))
		add(command, option);
}

void addOutcome(CLI::App& command, CommandLine& line, const char* reportHelp)
{
	add(command, reportOption(line, reportHelp));
	add(command, quietOption(line));
}

/// The file names of a command.
struct Files {
	std::string              in, out;
	std::vector<std::string> more;

	std::vector<std::string> all() const
	{
		std::vector<std::string> files = {in};
		if (!out.empty()) files.push_back(out);
		files.insert(files.end(), more.begin(), more.end());
		return files;
	}
};

/// A command that reads a mesh.
CLI::App* addCommand(CLI::App& app, const char* name, const char* help, std::string& in)
{
	CLI::App* command = app.add_subcommand(name, help);
	command->add_option("IN", in, inHelp())->required();
	command->footer(exitCodeHelp);
	return command;
}

void addRemesh(CLI::App& app, RemeshWords& words, Files& files)
{
	CLI::App* remesh = addCommand(app, "remesh", remeshDescription, files.in);
	remesh->add_option("OUT", files.out, outHelpOfRemesh());
	remesh->add_option("MORE", files.more, "With --out-dir: further input meshes");
	addInGroups(*remesh, words.options());
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
						  " takes numbers above 0, separated by commas, not '" + text + "'.");
			line.levels.sizes.push_back(size);
		}
	};
	levels.add_option_function<std::string>(option, keep, help)->type_name("N,N,...");
}

/// Several sizes of one mesh.
void addLevels(CLI::App& app, CommandLine& line, GivenOptions& given)
{
	CLI::App* levels =
		addCommand(app, "levels",
				   "Remeshes IN to several sizes, such as levels of detail, and writes a file for\n"
				   "each size. IN is read and prepared once. Each level has a proven bound of the\n"
				   "distance from IN.",
				   line.input);
	levels
		->add_option("OUT", line.output,
					 "Files to write, with {level} for the number of the level from 1 on, such as\n"
					 "small_{level}.ply; or one .glb file for all, by the extension MSFT_lod")
		->required();
	addLevelSizes(*levels, "--percent", "Sizes in percent of IN's vertices, such as 50,25,10,5",
				  TargetMode::Percent, line);
	addLevelSizes(*levels, "--vertices", "Sizes as numbers of vertices", TargetMode::VertexNum,
				  line);
	addLevelSizes(*levels, "--faces", "Sizes as numbers of faces", TargetMode::FaceNum, line);
	addInGroups(*levels, tableOptions(RemeshTool, given, isForLevels));
	addInGroups(*levels, valueOptions(line));
	addOutcome(*levels, line, "Write a report of each level as JSON, in the list 'levels'");
}

void addInfo(CLI::App& app, CommandLine& line)
{
	addCommand(app, "info", "Prints counts, topology and quality of IN.", line.input)
		->add_flag("--json", line.json, "Print JSON");
}

bool isForStep(const Parameter& p)
{
	return !isForPlan(p);
}

/// The other methods have no time limit and remesh the whole mesh; all results are checked.
bool isForCompare(const Parameter& p)
{
	const std::string key = p.key;
	return key != "TimeLimit" && key != "Selected" && key != "Check";
}

void addCompare(CLI::App& app, CommandLine& line, GivenOptions& given)
{
	CLI::App* compare = addCommand(
		app, "compare",
		"Remeshes IN with these options, with the preset paper and by MeshLab's Quadric\n"
		"Edge Collapse. Prints a table of times, distances from IN and triangle quality.",
		line.input);
	addInGroups(*compare, tableOptions(RemeshTool, given, isForCompare));
	compare->add_flag("--isotropic", line.isotropic,
					  "Also run MeshLab's Isotropic Explicit Remeshing");
	compare
		->add_option("--runs", line.runNum,
					 "Number of runs of each method; the table has the median time")
		->check(CLI::Range(1, 101))
		->type_name("K");
	compare->add_flag("--json", line.json, "Print JSON");
	compare
		->add_option("--html", line.htmlFolder,
					 "Write the page DIR/index.html with rotatable views and pictures")
		->type_name("DIR");
}

void addFeatures(CLI::App& app, CommandLine& line, GivenOptions& given)
{
	CLI::App* features = addCommand(
		app, "features",
		"Detects crease edges and cone apexes of IN. OUT is the same mesh with the strength of\n"
		"each vertex, in degrees, as quality and as colour, and with the features selected.",
		line.input);
	features->add_option("OUT", line.output, "Mesh to write: .ply; may be IN")->required();
	addTableOptions(*features, FeatureTool, given);
	addOutcome(*features, line, "Write thresholds and counts as JSON");
}

CLI::App* addTileStep(CLI::App& tile, CommandLine& line, TileStep step, const char* name,
					  const char* help)
{
	CLI::App* const command = tile.add_subcommand(name, help);
	command->add_option("DIR", line.tiles.folder, "The folder of the run")->required();
	command->callback([&line, step] { line.tiles.step = step; });
	return command;
}

/// The steps of a run in tiles, for several machines with a common folder.
void addTile(CLI::App& app, CommandLine& line, GivenOptions& given)
{
	CLI::App* const tile = app.add_subcommand(
		"tile", "The steps of a run in tiles, for many machines that share the folder DIR: plan,\n"
				"split, part for every tile, join, finish. Finished steps are not repeated.");
	tile->require_subcommand(1);
	CLI::App* const plan = addTileStep(*tile, line, TileStep::Plan, "plan",
									   "Decides how to cut IN, by a sample of a binary PLY file.\n"
									   "A file of another format is converted first.");
	plan->add_option("IN", line.tiles.inputs,
					 "PLY, OBJ, OFF or binary STL files, pieces of one surface")
		->required();
	addInGroups(*plan, tableOptions(RemeshTool, given, isForPlan));
	add(*plan, memoryOption(line));
	plan->add_option("--tiles", line.tiles.tileNum,
					 "Number of tiles; by default as the memory allows")
		->check(CLI::Range(1, 10000))
		->type_name("T");
	addTileStep(*tile, line, TileStep::Split, "split", "Reads IN once and writes all tiles.");
	CLI::App* const part =
		addTileStep(*tile, line, TileStep::Part, "part", "Condenses a single tile.");
	part->add_option("--unit", line.tiles.unit, "Number of the tile, from 0")->required();
	addTableOptions(*part, RemeshTool, given, isForStep);
	addTileStep(*tile, line, TileStep::Join, "join", "Puts the condensed tiles together.");
	CLI::App* const finish =
		addTileStep(*tile, line, TileStep::Finish, "finish", "Remeshes the joined tiles.");
	finish->add_option("OUT", line.output, outHelp())->required();
	addTableOptions(*finish, RemeshTool, given, isForStep);
	addOutcome(*finish, line, "Write a report of the run and the result as JSON");
	add(*finish, tilesOutOption(line));
	tile->footer(exitCodeHelp);
}

/// An option for the build, which installs the page; --help does not show this option.
void addManualPage(CLI::App& app)
{
	const auto printPage = [&app] {
		print(manualPage(app));
		throw CLI::Success();
	};
	app.add_flag_callback("--manual-page", printPage)->group("");
}

} // namespace

CommandLine parseCommandLine(int argc, char** argv)
{
	CommandLine  line;
	RemeshWords  remeshWords;
	Files        files;
	GivenOptions given; // of the given command only: there is no second command
	CLI::App     app("Remeshes triangle meshes by geodesic Poisson-disk sampling.", "gpremesh");
	app.set_version_flag("--version", std::string("gpremesh ") + GPR_VERSION,
						 "Show the version and exit");
	app.set_help_flag("-h,--help", "Show the everyday options and exit");
	app.set_help_all_flag("--help-all", "Show all options and exit");
	app.formatter(std::make_shared<GroupedHelp>());
	app.require_subcommand(1);
	app.allow_windows_style_options(false); // a path may begin with '/' everywhere
	app.footer("'gpremesh COMMAND --help' lists the everyday options of a command,\n"
			   "'gpremesh COMMAND --help-all' all options.\n"
			   "'gpremesh IN -o OUT' is 'gpremesh remesh IN OUT'.\n\n" +
			   std::string(exitCodeHelp));
	addRemesh(app, remeshWords, files);
	addInfo(app, line);
	addCompare(app, line, given);
	addFeatures(app, line, given);
	addTile(app, line, given);
	addLevels(app, line, given);
	addManualPage(app);
	try {
		std::vector<std::string> words = withCommand({argv + std::min(argc, 1), argv + argc});
		std::reverse(words.begin(), words.end()); // in the parser's order
		app.parse(std::move(words));
	}
	catch (const CLI::Success& wish) { // --help, --help-all, --version and --manual-page
		app.exit(wish);
		return line;
	}
	catch (const CLI::ParseError& error) {
		failUsage(sentence(error.what()) + " See gpremesh --help.");
	}
	line.command = commandNamed(app.get_subcommands().front()->get_name());
	if (line.command == Command::Remesh) {
		remeshWords.takeFiles(files.all());
		return remeshWords.line();
	}
	complete(given, line);
	return line;
}

} // namespace gpr::app
