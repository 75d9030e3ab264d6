// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_bridge.h"

#include <QString>
#include <QStringList>

#if __has_include(<common/filter_parameter/rich_parameter_list.h>)
#include <common/filter_parameter/rich_parameter_list.h> // MeshLab 2020.09
#else
#include <common/parameters/rich_parameter_list.h>
#define RichAbsPerc RichPercentage // its name since 2022
#endif

#include <charconv>
#include <cmath>
#include <optional>

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

void addRow(const Parameter& row, const gpr::MeshFacts& facts, RichParameterList& list)
{
	const ParameterValue value = row.defaultValue(facts);
	const QString        key   = QString::fromUtf8(row.key);
	const QString        label = QString::fromUtf8(row.label);
	const QString        help  = QString::fromUtf8(row.help);
	// The dialog divides by the range of a length: an empty layer gets one, too.
	const float diagonal = facts.diagonal > 0 ? float(facts.diagonal) : 1.f;
	switch (row.kind) {
	case ParameterKind::Count:
		list.addParam(RichInt(key, int(std::get<std::int64_t>(value)), label, help));
		break;
	case ParameterKind::Number:
		list.addParam(RichFloat(key, float(std::get<double>(value)), label, help));
		break;
	case ParameterKind::Length:
		list.addParam(RichAbsPerc(key, float(std::get<double>(value)), 0, diagonal, label, help));
		break;
	case ParameterKind::Switch:
		list.addParam(RichBool(key, std::get<bool>(value), label, help));
		break;
	case ParameterKind::Choice:
		list.addParam(
			RichEnum(key, int(std::get<std::int64_t>(value)), textsOf(row.choices), label, help));
		break;
	}
}

/// The row's value in a list that has it; nothing where it is of another type.
/// Asked for the type first, because MeshLab asserts on the wrong one.
std::optional<ParameterValue> find(const Parameter& row, const RichParameterList& list)
{
	const Value& value = list.getParameterByName(QString::fromUtf8(row.key)).value();
	switch (row.kind) {
	case ParameterKind::Count:
		if (value.isInt()) return ParameterValue(std::int64_t(value.getInt()));
		break;
	case ParameterKind::Number:
		if (value.isFloat()) return ParameterValue(typedNumber(value.getFloat()));
		break;
	case ParameterKind::Length:
		if (value.isAbsPerc()) return ParameterValue(typedNumber(value.getAbsPerc()));
		break;
	case ParameterKind::Switch:
		if (value.isBool()) return ParameterValue(value.getBool());
		break;
	case ParameterKind::Choice:
		if (value.isEnum()) return ParameterValue(std::int64_t(value.getEnum()));
		break;
	}
	return std::nullopt;
}

double numberOf(const ParameterValue& value)
{
	if (const auto* count = std::get_if<std::int64_t>(&value)) return double(*count);
	if (const auto* number = std::get_if<double>(&value)) return *number;
	return std::get<bool>(value);
}

bool inRange(const Parameter& row, const ParameterValue& value)
{
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

} // namespace

void fillParameterList(const std::vector<Parameter>& table, const gpr::MeshFacts& facts,
					   RichParameterList& list)
{
	for (const Parameter& row : table) {
		addRow(row, facts, list);
	}
}

ReadParameters readParameterList(const std::vector<Parameter>& table, const gpr::MeshFacts& facts,
								 const RichParameterList& list)
{
	ReadParameters read;
	for (const Parameter& row : table) {
		if (!list.hasParameter(QString::fromUtf8(row.key))) {
			read.values.set(row, row.defaultValue(facts));
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
			read.values.set(row, *value);
		}
	}
	// Only when every row was usable: the rest would be about values that nobody gave.
	if (read.complaints.empty()) read.complaints = read.values.complaints();
	return read;
}

double typedNumber(float kept)
{
	if (!std::isfinite(kept)) return double(kept);
	char       text[64];
	const auto written = std::to_chars(text, text + sizeof(text), kept);
	double     typed   = double(kept);
	std::from_chars(text, written.ptr, typed);
	return typed;
}

} // namespace gpr_filter
