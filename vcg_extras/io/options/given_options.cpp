// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_options.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/text/number_text.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace gpr::app {

namespace {

/// A size of 0 means "off" in the dialog; elsewhere a missing size is off, and 0 a mistake.
bool isAboveMinimum(const Parameter& p)
{
	return isSizeParameter(p) && p.minimum == 0;
}

[[noreturn]] void failRange(const Parameter& p, const std::string& kind, const std::string& given)
{
	failUsage(std::string(p.option) + " takes " + kind + rangeText(p) + ", not '" + given + "'.");
}

ParameterValue parseCount(const Parameter& p, const std::string& given)
{
	std::int64_t value = 0;
	if (!parseInteger(given, value) || !isInRange(p, double(value)))
		failRange(p, "a whole number", given);
	return value;
}

ParameterValue parseReal(const Parameter& p, const std::string& given)
{
	double value = 0;
	if (p.isAutomatic && given == automaticName) return Automatic();
	if (const auto percent = percentOf(p, given)) return *percent;
	if (!parseNumber(given, value) || !isInRange(p, value)) failRange(p, numberKind(p), given);
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

} // namespace

std::string plainText(double value)
{
	std::ostringstream text;
	text.imbue(std::locale::classic());
	text.precision(10);
	text << value;
	return text.str();
}

std::string numberKind(const Parameter& p)
{
	return p.isAutomatic ? std::string(automaticName) + " or a number" : "a number";
}

std::string rangeText(const Parameter& p)
{
	const bool  open = isAboveMinimum(p);
	std::string text = open ? " above 0" : " from " + plainText(p.minimum);
	if (p.maximum < 1e100) text += (open ? ", at most " : " to ") + plainText(p.maximum);
	return text;
}

bool isInRange(const Parameter& p, double value)
{
	if (!std::isfinite(value) || (isAboveMinimum(p) && value <= 0)) return false;
	return value >= p.minimum && value <= p.maximum;
}

std::string defaultText(const Parameter& p)
{
	if (isSizeParameter(p)) return "";
	if (p.isAutomatic) return automaticName;
	const ParameterValue value = p.defaultValue(MeshFacts());
	if (p.kind == ParameterKind::Switch) return std::get<bool>(value) ? "on" : "off";
	if (p.kind == ParameterKind::Choice) {
		return p.choices[std::size_t(std::get<std::int64_t>(value))];
	}
	return plainText(p.kind == ParameterKind::Count ? double(std::get<std::int64_t>(value))
													: std::get<double>(value));
}

std::string pythonName(const Parameter& p, Tool tool)
{
	std::string name = p.option;
	name.erase(0, name.find_first_not_of('-'));
	std::replace(name.begin(), name.end(), '-', '_');
	if (name == "vertices") return tool == SamplingTool ? "count" : "vertex_count";
	if (name == "faces") return "face_count";
	if (name == "lambda") return "lambda_";
	return name;
}

const char* kindName(ParameterKind kind)
{
	constexpr const char* names[] = {"count", "number", "length", "switch", "choice"};
	return names[int(kind)];
}

bool choosesSize(const Parameter& row, const std::string& word)
{
	return isSizeParameter(row) && word != "off";
}

std::optional<ParameterValue> percentOf(const Parameter& p, const std::string& word)
{
	double     value  = 0;
	const bool isRead = p.kind == ParameterKind::Length && !word.empty() && word.back() == '%' &&
						parseNumber(word.substr(0, word.size() - 1), value);
	if (!isRead || !isInRange(p, value)) return std::nullopt;
	return PercentOfDiagonal{value};
}

RemeshOptions optionsOf(const GivenOptions& given)
{
	ParameterSet set;
	int          sizeNum = 0;
	for (const auto& [row, word] : given) {
		sizeNum += choosesSize(*row, word) ? 1 : 0;
		set.set(*row, parseValue(*row, word));
	}
	if (sizeNum > 1) {
		failUsage("give only one of --vertices, --faces, --percent, --edge-length, --max-error "
				  "and --detail.");
	}
	const std::vector<std::string> complaints = set.complaints();
	if (!complaints.empty()) failUsage(complaints.front());
	return set.options();
}

RemeshOptions optionsOfText(const std::string& text)
{
	GivenOptions       given;
	std::istringstream words(text);
	for (std::string option; words >> option;) {
		const std::vector<Parameter>& rows = parametersOf(RemeshTool);
		const auto                    row  = std::find_if(rows.begin(), rows.end(),
														  [&](const Parameter& p) { return option == p.option; });
		if (row == rows.end()) failUsage("there is no option " + option + ".");
		std::string word = "on";
		if (!std::string(row->argument).empty()) words >> word;
		given[&*row] = word;
	}
	return optionsOf(given);
}

std::string textOf(const GivenOptions& given, bool (*isWanted)(const Parameter&))
{
	std::map<std::string, std::string> words; // by option: the rows' addresses have no order
	for (const auto& [row, word] : given) {
		if (isWanted != nullptr && !isWanted(*row)) continue;
		words[row->option] = std::string(row->argument).empty() ? "" : " " + word;
	}
	std::string text;
	for (const auto& [option, word] : words)
		text += (text.empty() ? "" : " ") + option + word;
	return text;
}

} // namespace gpr::app
