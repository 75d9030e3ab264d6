// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Makes vcg_extras/docs/parameters.md and the scripts of filter_geodesic_poisson/mlx from the
// engine's parameter table.
//
//   gpr_parameter_reference                 prints the page
//   gpr_parameter_reference --write ROOT    writes the page and the scripts into the repository
//   gpr_parameter_reference --check ROOT    ends with 0 if all files are up to date, else with 1
#include "filter_text.h"

#include <vcg_extras/core/parameter_table.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using gpr::MeshFacts;
using gpr::Parameter;
using gpr::ParameterKind;
using gpr::ParameterValue;

using gpr_filter::Filter;
using gpr_filter::scriptType;
using gpr_filter::textOf;

constexpr Filter filters[] = {gpr_filter::RemeshFilter, gpr_filter::SamplingFilter,
							  gpr_filter::RetriangulateFilter, gpr_filter::FeatureFilter,
							  gpr_filter::CompareFilter};

const char* const intro =
	"<!-- Made by build/bin/gpr_parameter_reference --write . from "
	"vcg_extras/core/parameter_table.cpp; do not edit. -->\n"
	"# Parameters\n"
	"\n"
	"The options of `gpremesh`, the parameters of MeshLab's filters and this page come from one\n"
	"table; a few parameters exist in MeshLab only. The first part lists the parameters of each\n"
	"filter, the second part [describes each parameter](#descriptions).\n"
	"\n"
	"A script for `meshlabserver` names every key of its filter with its type. Each filter has a\n"
	"complete script: edit `TargetVertexNum`. Dialogs with more than twelve parameters hide the\n"
	"rows below the line *for experts* behind an arrow.\n";

std::string plain(double value)
{
	std::ostringstream text;
	text.precision(10);
	text << value;
	return text.str();
}

/// A text for a cell of a table: a bar would end the cell even within code.
std::string inCell(std::string text)
{
	for (std::size_t at = text.find('|'); at != text.npos; at = text.find('|', at + 2))
		text.insert(at, "\\");
	return text;
}

/// Whole numbers as such, however large.
std::string plain(const Parameter& p, double value)
{
	return p.kind == ParameterKind::Count ? std::to_string((long long) value) : plain(value);
}

std::string code(const std::string& text)
{
	return "`" + text + "`";
}

std::string optionText(const Parameter& p)
{
	if (std::string(p.option).empty()) return "–";
	const std::string argument = p.argument;
	return code(p.option + (argument.empty() ? "" : " " + argument));
}

std::string rangeText(const Parameter& p)
{
	if (p.kind == ParameterKind::Switch) return "on, off";
	if (p.kind == ParameterKind::Choice) {
		std::string names;
		for (const char* choice : p.choices)
			names += (names.empty() ? "" : ", ") + std::string(choice);
		return names;
	}
	const std::string least = (p.isAutomatic ? "auto, " : "") + plain(p, p.minimum);
	if (p.maximum >= 1e100) return "from " + least;
	return least + " to " + plain(p, p.maximum);
}

double numberOf(const ParameterValue& value)
{
	if (const auto* count = std::get_if<std::int64_t>(&value)) return double(*count);
	if (const auto* number = std::get_if<double>(&value)) return *number;
	return std::get<bool>(value) ? 1 : 0;
}

/// A default that depends on the mesh is told as a share of its base.
std::string defaultText(const Parameter& p)
{
	if (p.isAutomatic) return gpr::automaticName;
	const MeshFacts unit{1000000, 1.0}, more{2000000, 1.0}, larger{1000000, 2.0};
	const double    value = numberOf(p.defaultValue(unit));
	if (numberOf(p.defaultValue(more)) != value)
		return plain(100 * value / double(unit.vertexNum)) + " % of the vertices";
	if (numberOf(p.defaultValue(larger)) != value)
		return plain(100 * value / unit.diagonal) + " % of the diagonal";
	if (p.kind == ParameterKind::Switch) return value != 0 ? "on" : "off";
	if (p.kind == ParameterKind::Choice) return p.choices[std::size_t(value)];
	return plain(p, value);
}

// ---- the page

std::string overviewRow(const Parameter& p, bool withOption)
{
	return (withOption ? "| " + inCell(optionText(p)) + " " : "") + "| [" + code(p.key) + "](#" +
		   p.key + ") | " + scriptType(p.kind) + " | " + rangeText(p) + " | " + defaultText(p) +
		   " |\n";
}

/// Whether the program has a command for this filter.
bool isCommand(Filter filter)
{
	return filter == gpr_filter::RemeshFilter || filter == gpr_filter::FeatureFilter ||
		   filter == gpr_filter::CompareFilter;
}

std::string overview(Filter filter)
{
	const bool  withOption = isCommand(filter);
	std::string text       = withOption ? "| command line " : "";
	text += "| filter key | type in a script | range | default |\n";
	text += withOption ? "|---|---|---|---|---|\n" : "|---|---|---|---|\n";
	bool expert = false;
	for (const Parameter& p : gpr_filter::rowsOf(filter)) {
		if (p.isExpert && !expert)
			text += withOption ? "| | *for experts* | | | |\n" : "| *for experts* | | | |\n";
		expert = p.isExpert;
		text += overviewRow(p, withOption);
	}
	return text;
}

std::string scriptLink(Filter filter)
{
	const std::string file = textOf(filter).pythonName + std::string(".mlx");
	return "Script: [" + file + "](../../filter_geodesic_poisson/mlx/" + file + ")\n";
}

std::string chapter(Filter filter)
{
	std::string text = std::string("\n## ") + textOf(filter).name + "\n\n";
	if (filter == gpr_filter::RemeshFilter)
		text +=
			"`gpremesh remesh` takes `--vertices`, `--percent` or `--edge-length`, by default 10 % "
			"of the\n"
			"vertices, and writes to OUT in place of a new layer.\n\n";
	if (filter == gpr_filter::CompareFilter)
		text += "`gpremesh compare` takes no time limit. With `--html` it writes a page.\n\n";
	if (filter == gpr_filter::FeatureFilter)
		text +=
			"`gpremesh features` writes the same quality and selection, and colours, to OUT.\n\n";
	return text + overview(filter) + "\n" + scriptLink(filter);
}

/// Sentences about a single host, as a separate paragraph.
std::string inHost(const char* host, const std::string& sentences)
{
	return sentences.empty() ? sentences : std::string("\n*") + host + ":* " + sentences + "\n";
}

/// The rows of all filters, first the engine's rows.
std::vector<Parameter> allRows()
{
	std::vector<Parameter> rows = gpr::makeParameterTable();
	std::set<std::string>  keys;
	for (const Parameter& p : rows)
		keys.insert(p.key);
	for (Filter filter : filters) {
		for (const Parameter& p : gpr_filter::rowsOf(filter))
			if (keys.insert(p.key).second) rows.push_back(p);
	}
	return rows;
}

std::string explanations()
{
	std::string text = "\n## Descriptions\n";
	for (const Parameter& p : allRows()) {
		const char* const automatic = p.isAutomatic ? "-1 means auto." : "";
		text += "\n<a id=\"" + std::string(p.key) + "\"></a>\n### " + p.label + "\n\n" +
				code(p.key) + (*p.option != '\0' ? ", " + optionText(p) : std::string()) + "\n\n" +
				p.help + "\n" + inHost("In MeshLab", automatic + std::string(p.dialogOnly)) +
				inHost("On the command line", p.commandOnly) + inHost("In Python", p.pythonOnly);
	}
	return text;
}

std::string page()
{
	std::string text = intro;
	for (Filter filter : filters)
		text += chapter(filter);
	return text + explanations();
}

// ---- scripts

/// The value in a script, which is made for any mesh. A user edits the number of vertices first.
ParameterValue scriptValue(const Parameter& p)
{
	return p.defaultValue(MeshFacts{100000, 1.0});
}

std::string valueText(const Parameter& p, const ParameterValue& value)
{
	if (p.kind == ParameterKind::Switch) return std::get<bool>(value) ? "true" : "false";
	return plain(p, p.isAutomatic ? gpr_filter::kAutomaticNumber : numberOf(value));
}

/// Attributes of a type for meshlabserver, beside the name.
std::string typeAttributes(const Parameter& p)
{
	if (p.kind == ParameterKind::Length) return " min=\"0\" max=\"1\"";
	std::string text;
	if (p.kind != ParameterKind::Choice) return text;
	text += " enum_cardinality=\"" + std::to_string(p.choices.size()) + "\"";
	for (std::size_t i = 0; i < p.choices.size(); ++i)
		text += " enum_val" + std::to_string(i) + "=\"" + p.choices[i] + "\"";
	return text;
}

std::string script(Filter filter)
{
	std::string text = "<!DOCTYPE FilterScript>\n<FilterScript>\n <filter name=\"";
	text += textOf(filter).name + std::string("\">\n");
	for (const Parameter& p : gpr_filter::rowsOf(filter)) {
		text += "  <Param name=\"" + std::string(p.key) + "\" type=\"" + scriptType(p.kind) +
				"\" value=\"" + valueText(p, scriptValue(p)) + "\"" + typeAttributes(p) + "/>\n";
	}
	return text + " </filter>\n</FilterScript>\n";
}

// ---- the program

/// A file made from the table: its path below the repository's root, and its text.
struct MadeFile {
	std::string path, text;
};

std::vector<MadeFile> madeFiles()
{
	std::vector<MadeFile> files = {{"vcg_extras/docs/parameters.md", page()}};
	for (Filter filter : filters) {
		const std::string name = textOf(filter).pythonName;
		files.push_back({"filter_geodesic_poisson/mlx/" + name + ".mlx", script(filter)});
	}
	return files;
}

std::string contentOf(const std::string& path)
{
	std::ifstream file(path, std::ios::binary);
	return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool write(const std::string& root)
{
	bool good = true;
	for (const MadeFile& made : madeFiles()) {
		std::ofstream file(root + "/" + made.path, std::ios::binary);
		file << made.text;
		good = file.flush().good() && good;
	}
	return good;
}

bool check(const std::string& root)
{
	bool good = true;
	for (const MadeFile& made : madeFiles()) {
		if (contentOf(root + "/" + made.path) == made.text) continue;
		std::fprintf(stderr,
					 "%s differs from the parameter table; make it anew:\n"
					 "  build/bin/gpr_parameter_reference --write .\n",
					 made.path.c_str());
		good = false;
	}
	return good;
}

} // namespace

int main(int argc, char** argv)
{
	const std::string task = argc > 1 ? argv[1] : "";
	if (task == "--write" && argc == 3) return write(argv[2]) ? 0 : 1;
	if (task == "--check" && argc == 3) return check(argv[2]) ? 0 : 1;
	if (argc != 1) return 2;
	std::fputs(page().c_str(), stdout);
	return 0;
}
