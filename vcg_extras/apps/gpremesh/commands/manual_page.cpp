// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "manual_page.h"

#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

namespace gpr::app {

namespace {

const char* const nameAndWhat =
	".SH NAME\n"
	"gpremesh \\- remesh triangle meshes with nearly equilateral triangles\n";

const char* const description =
	".SH DESCRIPTION\n"
	"Turns a dense triangle mesh, such as a scan, into a mesh with nearly equilateral triangles\n"
	"and the exact number of vertices asked for. The result is fitted to the scan and keeps\n"
	"crease edges and borders. Every result is checked before the program writes a file; a faulty\n"
	"result is withheld.\n"
	".PP\n"
	"The extension of a file decides the format: ";

const char* const promises =
	".\n"
	"Only a complete OUT replaces an older file: after a failure the older file is unchanged.\n"
	"The same input, options and seed give the same bytes, with any number of threads, on every\n"
	"system.\n";

const char* const examples =
	".SH EXAMPLES\n"
	".EX\n"
	"gpremesh remesh scan.ply regular.ply \\-\\-vertices 20000\n"
	"gpremesh remesh scan.ply regular.ply \\-\\-percent 5 \\-\\-report report.json\n"
	"gpremesh remesh scan.ply close.ply \\-\\-adapt 1\n"
	"gpremesh features part.ply strengths.ply\n"
	"gpremesh compare scan.ply \\-\\-percent 10 \\-\\-html page\n"
	"gpremesh info regular.ply\n"
	".EE\n"
	".SH SEE ALSO\n"
	".BR meshlab (1),\n"
	".BR meshlabserver (1)\n";

/// Text for the formatter: escapes the signs of its language, and makes hyphens copyable.
std::string escaped(const std::string& text)
{
	std::string safe;
	for (const char c : text) {
		const bool lineBegins = safe.empty() || safe.back() == '\n';
		if (lineBegins && (c == '.' || c == '\'')) safe += "\\&";
		if (c == '-') safe += '\\';
		safe += c == '\\' ? "\\e" : std::string(1, c);
	}
	return safe;
}

/// One line of text: the formatter breaks lines itself.
std::string flowing(std::string text)
{
	std::replace(text.begin(), text.end(), '\n', ' ');
	return escaped(text) + "\n";
}

std::string upperCase(std::string text)
{
	for (char& c : text)
		c = char(std::toupper((unsigned char) c));
	return text;
}

/// Whether an option is for users, not for the project's own use.
bool isShown(const CLI::Option& option)
{
	return !option.get_group().empty();
}

std::vector<const CLI::Option*> optionsOf(const CLI::App& command, bool positional)
{
	return command.get_options([positional](const CLI::Option* option) {
		return isShown(*option) && option->get_positional() == positional;
	});
}

/// An option's entry: the name of a positional, or all names of an option with the argument.
std::string entry(const CLI::Option& option)
{
	std::string names;
	for (const std::string& name : option.get_snames())
		names += (names.empty() ? "\\-" : ", \\-") + name;
	for (const std::string& name : option.get_lnames())
		names += (names.empty() ? "\\-\\-" : ", \\-\\-") + escaped(name);
	const bool  positional = option.get_positional();
	std::string line       = "\\fB" + (positional ? option.get_name(true) : names) + "\\fR";
	if (!positional && !option.get_type_name().empty())
		line += " \\fI" + escaped(option.get_type_name()) + "\\fR";
	return ".TP\n" + line + "\n" + flowing(option.get_description());
}

std::string entries(const CLI::App& command, bool positional)
{
	std::string text;
	for (const CLI::Option* option : optionsOf(command, positional))
		text += entry(*option);
	return text;
}

std::string usage(const CLI::App& command)
{
	std::string line = "\\fBgpremesh " + command.get_name() + "\\fR [\\fIoptions\\fR]";
	for (const CLI::Option* option : optionsOf(command, true))
		line += " \\fI" + option->get_name(true) + "\\fR";
	return line + "\n.br\n";
}

std::string chapter(const CLI::App& command)
{
	return ".SH \"" + upperCase(command.get_name()) + "\"\n" + flowing(command.get_description()) +
		   entries(command, true) + entries(command, false);
}

/// The exit codes, from the last lines of --help: a number and words, maybe on two lines.
std::string exitStatus(const std::string& footer)
{
	std::istringstream lines(footer);
	std::string        text = ".SH EXIT STATUS\n", line;
	std::getline(lines, line); // the heading
	while (std::getline(lines, line)) {
		std::istringstream words(line);
		std::string        first, rest;
		words >> first;
		std::getline(words >> std::ws, rest);
		const bool code = first.size() == 1 && std::isdigit((unsigned char) first[0]) != 0;
		text += code ? ".TP\n\\fB" + first + "\\fR\n" + flowing(rest)
					 : flowing(first.append(" ").append(rest));
	}
	return text;
}

} // namespace

std::string manualPage(const CLI::App& program)
{
	const auto  commands = program.get_subcommands([](const CLI::App*) { return true; });
	std::string synopsis = ".SH SYNOPSIS\n", chapters;
	for (const CLI::App* command : commands) {
		synopsis += usage(*command);
		chapters += chapter(*command);
	}
	synopsis += "\\fBgpremesh \\-\\-help\\fR | \\fB\\-\\-version\\fR\n";
	return std::string(".\\\" -*- coding: utf-8 -*-\n.TH GPREMESH 1 \"\" \"gpremesh ") +
		   GPR_VERSION + "\" \"User Commands\"\n" + nameAndWhat + synopsis + description +
		   formatNames() + promises + chapters + exitStatus(commands.front()->get_footer()) +
		   examples;
}

} // namespace gpr::app
