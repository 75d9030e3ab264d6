// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include "exit_code.h"
#include "mesh_io.h"
#include "text_scanner.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>
#include <vcg_extras/core/parameters.h>

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

/// The three rows that stand for one choice, the size of the result. 0 means "off" in the dialog;
/// here an option that is not given is off, so 0 is a mistake.
bool isSizeOption(const Parameter& p)
{
	const std::string key = p.key;
	return key == "TargetVertexNum" || key == "TargetPerc" || key == "TargetLen";
}

/// A number as a person writes it: no trailing zeros.
std::string plain(double value)
{
	std::ostringstream text;
	text.imbue(std::locale::classic());
	text.precision(10);
	text << value;
	return text.str();
}

/// The range of a row in words: " from 0 to 1000", " above 0, at most 10000".
std::string rangeText(const Parameter& p)
{
	const bool  open = isSizeOption(p) && p.minimum == 0;
	std::string text = open ? " above 0" : " from " + plain(p.minimum);
	if (p.maximum < 1e100) text += (open ? ", at most " : " to ") + plain(p.maximum);
	return text;
}

[[noreturn]] void failRange(const Parameter& p, const std::string& kind, const std::string& given)
{
	failUsage(std::string(p.option) + " takes " + kind + rangeText(p) + ", not '" + given + "'.");
}

ParameterValue parseCount(const Parameter& p, const std::string& given)
{
	std::int64_t value = 0;
	if (!parseInteger(given, value) || double(value) < p.minimum || double(value) > p.maximum) {
		failRange(p, "a whole number", given);
	}
	return value;
}

ParameterValue parseReal(const Parameter& p, const std::string& given)
{
	double     value  = 0;
	const bool number = parseNumber(given, value) && std::isfinite(value);
	if (!number || value < p.minimum || value > p.maximum || (isSizeOption(p) && value <= 0)) {
		failRange(p, "a number", given);
	}
	return value;
}

ParameterValue parseSwitch(const Parameter& p, const std::string& given)
{
	if (given == "on" || given == "true") return true;
	if (given == "off" || given == "false") return false;
	failUsage(std::string(p.option) + " takes on or off, not '" + given + "'.");
}

ParameterValue parseChoice(const Parameter& p, const std::string& given)
{
	std::string names;
	for (std::size_t i = 0; i < p.choices.size(); ++i) {
		if (given == p.choices[i]) return std::int64_t(i);
		names += (i > 0 ? ", " : "") + std::string(p.choices[i]);
	}
	failUsage(std::string(p.option) + " takes one of " + names + ", not '" + given + "'.");
}

ParameterValue parseValue(const Parameter& p, const std::string& given)
{
	switch (p.kind) {
	case ParameterKind::Count:
		return parseCount(p, given);
	case ParameterKind::Number:
	case ParameterKind::Length:
		return parseReal(p, given);
	case ParameterKind::Switch:
		return parseSwitch(p, given);
	case ParameterKind::Choice:
		return parseChoice(p, given);
	}
	return false;
}

/// The default as the user would write it; empty for the size, whose default is a share.
std::string defaultText(const Parameter& p)
{
	if (isSizeOption(p)) return "";
	const ParameterValue value = p.defaultValue(MeshFacts());
	if (p.kind == ParameterKind::Switch) return std::get<bool>(value) ? "on" : "off";
	if (p.kind == ParameterKind::Choice) {
		return p.choices[std::size_t(std::get<std::int64_t>(value))];
	}
	return plain(p.kind == ParameterKind::Count ? double(std::get<std::int64_t>(value))
												: std::get<double>(value));
}

/// Breaks a text into lines that fit beside the names of the options on 100 columns.
std::string wrapped(const std::string& text)
{
	constexpr std::size_t width = 68;
	std::string           lines;
	std::size_t           used = 0;
	std::istringstream    words(text);
	for (std::string word; words >> word; used += word.size()) {
		if (used > 0) {
			const bool full = used + 1 + word.size() > width;
			lines += full ? '\n' : ' ';
			used = full ? 0 : used + 1;
		}
		lines += word;
	}
	return lines;
}

std::string helpText(const Parameter& p)
{
	const std::string value = defaultText(p);
	return wrapped(std::string(p.help) + (value.empty() ? "" : " Default: " + value + "."));
}

/// Values of the table's options, as words, until all arguments are known.
using GivenOptions = std::map<const Parameter*, std::string>;

void addTableOptions(CLI::App& app, GivenOptions& given)
{
	for (const Parameter& p : remeshParameters()) {
		if (std::string(p.option).empty()) continue;
		const Parameter* const row = &p;
		if (std::string(p.argument).empty()) {
			app.add_flag_callback(
				p.option, [row, &given] { given[row] = "on"; }, helpText(p));
			continue;
		}
		const auto keep = [row, &given](const std::string& word) { given[row] = word; };
		app.add_option_function<std::string>(p.option, keep, helpText(p))->type_name(p.argument);
	}
}

RemeshOptions optionsOf(const GivenOptions& given)
{
	ParameterSet set;
	int          sizeNum = 0;
	for (const auto& [row, word] : given) {
		sizeNum += isSizeOption(*row) ? 1 : 0;
		set.set(*row, parseValue(*row, word));
	}
	if (sizeNum > 1) failUsage("give only one of --vertices, --percent and --edge-length.");
	const std::vector<std::string> complaints = set.complaints();
	if (!complaints.empty()) failUsage(complaints.front());
	return set.options();
}

bool sameFile(const std::string& a, const std::string& b)
{
	std::error_code error;
	return std::filesystem::weakly_canonical(a, error) ==
		   std::filesystem::weakly_canonical(b, error);
}

void checkPaths(const CommandLine& line)
{
	formatOfPath(line.input);
	if (line.command != Command::Remesh) return;
	formatOfPath(line.output);
	if (line.report.empty()) return;
	if (sameFile(line.report, line.output) || sameFile(line.report, line.input)) {
		failUsage("--report must name another file than IN and OUT.");
	}
}

/// The parser's complaint with a full stop.
std::string sentence(std::string complaint)
{
	if (!complaint.empty() && complaint.back() != '.') complaint += '.';
	return complaint;
}

CLI::App* addRemesh(CLI::App& app, CommandLine& line, GivenOptions& given)
{
	CLI::App* remesh = app.add_subcommand(
		"remesh", "Remeshes IN with about-equilateral triangles of equal size and writes OUT.\n"
				  "The size is given by one of --vertices, --percent and --edge-length; 10 % of\n"
				  "IN's vertices where none is given.");
	remesh->add_option("IN", line.input, "Mesh to read: .ply, .obj, .off or .stl")->required();
	remesh->add_option("OUT", line.output, "Mesh to write, may be IN: .ply, .obj, .off or .stl")
		->required();
	addTableOptions(*remesh, given);
	remesh->add_option("--report", line.report, "Write what was done, and how well, as JSON")
		->type_name("FILE.json");
	remesh->add_flag("--quiet", line.quiet, "No progress and no summary; errors are told still");
	remesh->footer(exitCodeHelp);
	return remesh;
}

CLI::App* addInfo(CLI::App& app, CommandLine& line)
{
	CLI::App* info = app.add_subcommand("info", "Prints counts, topology and quality of IN.");
	info->add_option("IN", line.input, "Mesh to read: .ply, .obj, .off or .stl")->required();
	info->add_flag("--json", line.json, "Print JSON");
	info->footer(exitCodeHelp);
	return info;
}

} // namespace

CommandLine parseCommandLine(int argc, char** argv)
{
	CommandLine  line;
	GivenOptions given;
	CLI::App     app("Remeshes triangle meshes by geodesic Poisson-disk sampling.", "gpremesh");
	app.set_version_flag("--version", std::string("gpremesh ") + GPR_VERSION);
	app.require_subcommand(1);
	app.footer("'gpremesh COMMAND --help' tells the options of a command.\n\n" +
			   std::string(exitCodeHelp));
	CLI::App* const remesh = addRemesh(app, line, given);
	CLI::App* const info   = addInfo(app, line);
	try {
		app.parse(argc, argv);
	}
	catch (const CLI::Success& wish) { // --help and --version
		app.exit(wish);
		return line;
	}
	catch (const CLI::ParseError& error) {
		failUsage(sentence(error.what()) + " See gpremesh --help.");
	}
	if (remesh->parsed()) line.command = Command::Remesh;
	if (info->parsed()) line.command = Command::Info;
	line.options = optionsOf(given);
	checkPaths(line);
	return line;
}

} // namespace gpr::app
