// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_bridge.h"

#include "filter_text.h"
#include "old_parameters.h"
#include "parameter_api.h"

#include <QString>
#include <QStringList>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace gpr_filter {

namespace {

using gpr::Parameter;
using gpr::ParameterKind;
using gpr::ParameterValue;

QStringList textsOf(const std::vector<const char*>& choices)
{
	QStringList texts;
	for (const char* choice : choices) {
		texts << QString::fromUtf8(choice);
	}
	return texts;
}

/// In the form of widgets and scripts.
double scriptNumber(const ParameterValue& value)
{
	return std::holds_alternative<gpr::Automatic>(value) ? kAutomaticNumber
														 : std::get<double>(value);
}

void addRow(const Parameter& row, const gpr::MeshFacts& facts, const ParameterValue& value,
			bool advanced, RichParameterList& list)
{
	const QString key   = QString::fromUtf8(row.key);
	const QString label = QString::fromStdString(dialogLabel(row));
	const QString help  = QString::fromStdString(gpr::dialogHelp(row));
	// The dialog divides by the range of a length: an empty layer gets a range, too.
	const Scalarm diagonal = facts.diagonal > 0 ? Scalarm(facts.diagonal) : 1;
	switch (row.kind) {
	case ParameterKind::Count:
		addParameter<RichInt>(list, advanced, key, int(std::get<std::int64_t>(value)), label, help);
		break;
	case ParameterKind::Number:
		addParameter<RichFloat>(list, advanced, key, Scalarm(scriptNumber(value)), label, help);
		break;
	case ParameterKind::Length:
		addParameter<LengthParameter>(list, advanced, key, Scalarm(std::get<double>(value)),
									  Scalarm(0), diagonal, label, help);
		break;
	case ParameterKind::Switch:
		addParameter<RichBool>(list, advanced, key, std::get<bool>(value), label, help);
		break;
	case ParameterKind::Choice:
		addParameter<RichEnum>(list, advanced, key, int(std::get<std::int64_t>(value)),
							   textsOf(row.choices), label, help);
		break;
	}
}

ParameterValue numberIn(const Parameter& row, double number)
{
	if (row.isAutomatic && number == kAutomaticNumber) return gpr::Automatic();
	return number;
}

/// The row's value in a list with this row; nothing for a value of another type. The type is tested
/// first, because MeshLab asserts on the wrong type.
std::optional<ParameterValue> find(const Parameter& row, const RichParameterList& list)
{
	const RichParameter& parameter = list.getParameterByName(QString::fromUtf8(row.key));
	if (parameter.stringType() != scriptType(row.kind)) return std::nullopt;
	switch (row.kind) {
	case ParameterKind::Switch:
		return ParameterValue(parameter.value().getBool());
	case ParameterKind::Number:
	case ParameterKind::Length:
		return numberIn(row, typedNumber(parameter.value().getFloat()));
	default:
		return ParameterValue(std::int64_t(parameter.value().getInt()));
	}
}

bool isAutomatic(const ParameterValue& value)
{
	return std::holds_alternative<gpr::Automatic>(value);
}

double numberOf(const ParameterValue& value)
{
	if (const auto* count = std::get_if<std::int64_t>(&value)) return double(*count);
	if (const auto* number = std::get_if<double>(&value)) return *number;
	return std::get<bool>(value);
}

bool inRange(const Parameter& row, const ParameterValue& value)
{
	if (isAutomatic(value)) return true;
	const double number = numberOf(value);
	if (row.kind == ParameterKind::Choice) {
		return number >= 0 && number < double(row.choices.size());
	}
	return number >= row.minimum && number <= row.maximum; // false for NaN
}

std::string outOfRange(const Parameter& row)
{
	return QStringLiteral("%1 (%2) must be between %3 and %4.")
		.arg(QString::fromUtf8(row.label), QString::fromUtf8(row.key))
		.arg(row.minimum, 0, 'g', 10)
		.arg(row.maximum, 0, 'g', 10)
		.toStdString();
}

ParameterValue valueOf(const Parameter& row, const gpr::MeshFacts& facts, const GivenValues& given)
{
	const auto found = given.find(row.key);
	return found != given.end() ? found->second : row.defaultValue(facts);
}

void keep(const Parameter& row, const ParameterValue& value, ReadParameters& read)
{
	if (row.store == nullptr)
		read.ofHost[row.key] = value;
	else
		read.values.set(row, value);
}

/// An adaptivity of 0.1 meant no choice.
bool isOldDefault(const Parameter& row, const ParameterValue& value, const RichParameterList& list)
{
	constexpr double oldDefault = 0.1;
	return row.isAutomatic && !isAutomatic(value) && numberOf(value) == oldDefault &&
		   isOldScript(list);
}

} // namespace

std::size_t everydayRowNum(const std::vector<Parameter>& table)
{
	if (table.size() <= kMostEverydayRows) return table.size();
	const auto first =
		std::find_if(table.begin(), table.end(), [](const Parameter& p) { return p.isExpert; });
	return std::size_t(first - table.begin());
}

void fillParameterList(const std::vector<Parameter>& table, const gpr::MeshFacts& facts,
					   RichParameterList& list, const GivenValues& given)
{
	const std::size_t shown = everydayRowNum(table);
	for (std::size_t i = 0; i < table.size(); ++i)
		addRow(table[i], facts, valueOf(table[i], facts, given), i >= shown, list);
}

ReadParameters readParameterList(const std::vector<Parameter>& table, const gpr::MeshFacts& facts,
								 const RichParameterList& list, const GivenValues& proposed)
{
	ReadParameters read;
	read.notes = notesOnOldParameters(list);
	for (const Parameter& row : table) {
		if (!list.hasParameter(QString::fromUtf8(row.key))) {
			keep(row, valueOf(row, facts, proposed), read);
			continue;
		}
		const std::optional<ParameterValue> value = find(row, list);
		if (!value) {
			read.complaints.push_back(std::string("The parameter ") + row.key +
									  " is of another type.");
		}
		else if (!inRange(row, *value)) {
			read.complaints.push_back(outOfRange(row));
		}
		else {
			keep(row, isOldDefault(row, *value, list) ? row.defaultValue(facts) : *value, read);
		}
	}
	// Only if every row was usable: otherwise complaints would be about values that nobody gave.
	if (read.complaints.empty()) read.complaints = read.values.complaints();
	return read;
}

double typedNumber(double kept)
{
	const float asFloat = float(kept);
	if (double(asFloat) != kept || !std::isfinite(asFloat)) return kept;
	char       text[64];
	const auto written = std::to_chars(text, text + sizeof(text), asFloat);
	double     typed   = kept;
	std::from_chars(text, written.ptr, typed);
	return typed;
}

} // namespace gpr_filter
