// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Makes vcg_extras/docs/parameters.md from the engine's parameter table.
//
//   gpr_parameter_reference           prints the page
//   gpr_parameter_reference FILE      ends with 0 where FILE is that page, else with 1
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vcg_extras/core/parameters.h>

namespace {

using gpr::MeshFacts;
using gpr::Parameter;
using gpr::ParameterKind;
using gpr::ParameterValue;

const char* const intro =
	"<!-- Made by build/bin/gpr_parameter_reference from vcg_extras/core/parameter_table.cpp; do "
	"not "
	"edit. "
	"-->\n"
	"# Parameters\n"
	"\n"
	"The options of `gpremesh remesh` and the parameters of MeshLab's filter \"Remeshing: "
	"Geodesic\n"
	"Poisson Disk\" are made from one table, and so is this page. A script for `meshlabserver` "
	"names\n"
	"every key, with its type; a complete one is\n"
	"[meshing_geodesic_poisson_disk_remeshing.mlx](../../filter_geodesic_poisson/mlx/"
	"meshing_geodesic_poisson_disk_remeshing.mlx).\n"
	"\n";

std::string plain(double value)
{
	std::ostringstream text;
	text.precision(10);
	text << value;
	return text.str();
}

/// For a cell of a table, where a bar ends the cell even within code.
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

const char* scriptType(ParameterKind kind)
{
	switch (kind) {
	case ParameterKind::Count:
		return "RichInt";
	case ParameterKind::Number:
		return "RichFloat";
	case ParameterKind::Length:
		return "RichAbsPerc";
	case ParameterKind::Switch:
		return "RichBool";
	case ParameterKind::Choice:
		return "RichEnum";
	}
	return "";
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
	const std::string least = plain(p, p.minimum);
	if (p.maximum >= 1e100) return "from " + least;
	return least + " to " + plain(p, p.maximum);
}

double numberOf(const ParameterValue& value)
{
	if (const auto* count = std::get_if<std::int64_t>(&value)) return double(*count);
	if (const auto* number = std::get_if<double>(&value)) return *number;
	return std::get<bool>(value) ? 1 : 0;
}

/// Defaults that go with the mesh are told as a share of what they go with.
std::string defaultText(const Parameter& p)
{
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

std::string overview()
{
	std::string text = "| command line | filter key | type in a script | range | default |\n"
					   "|---|---|---|---|---|\n";
	for (const Parameter& p : gpr::remeshParameters()) {
		text += "| " + inCell(optionText(p)) + " | [" + code(p.key) + "](#" + p.key + ") | " +
				scriptType(p.kind) + " | " + rangeText(p) + " | " + defaultText(p) + " |\n";
	}
	return text;
}

std::string explanations()
{
	std::string text;
	for (const Parameter& p : gpr::remeshParameters()) {
		text += "\n<a id=\"" + std::string(p.key) + "\"></a>\n### " + p.label + "\n\n" +
				code(p.key) + (*p.option != '\0' ? ", " + optionText(p) : std::string()) + "\n\n" +
				p.help + "\n";
	}
	return text;
}

std::string page()
{
	return intro + overview() +
		   "\nThe command line takes one of `--vertices`, `--percent` and `--edge-length`, 10 % of "
		   "the\n"
		   "vertices where none is given, and writes to OUT, so that it needs no new layer.\n" +
		   explanations();
}

std::string contentOf(const char* path)
{
	std::ifstream file(path, std::ios::binary);
	return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace

int main(int argc, char** argv)
{
	if (argc < 2) {
		std::fputs(page().c_str(), stdout);
		return 0;
	}
	if (contentOf(argv[1]) == page()) return 0;
	std::fprintf(stderr,
				 "%s differs from the parameter table; make it anew:\n"
				 "  build/bin/gpr_parameter_reference > vcg_extras/docs/parameters.md\n",
				 argv[1]);
	return 1;
}
