// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_values.h"

#include <vcg_extras/io/options/given_options.h>

#include <algorithm>
#include <nanobind/stl/string.h>
#include <vector>

namespace nb = nanobind;

namespace gpr::python {

namespace {

/// Whether a row is an argument. The switch for selected faces is none: the array of the faces
/// replaces the switch.
bool isArgument(const Parameter& p)
{
	return *p.option != '\0' && std::string(p.key) != "Selected";
}

const Parameter* findArgument(Tool tool, const std::string& name)
{
	for (const Parameter& p : parametersOf(tool)) {
		if (isArgument(p) && app::pythonName(p, tool) == name) return &p;
	}
	return nullptr;
}

[[noreturn]] void failValue(const std::string& name, const std::string& wanted, nb::handle value)
{
	const std::string given = nb::cast<std::string>(nb::repr(value));
	throw nb::value_error((name + " takes " + wanted + ", not " + given + ".").c_str());
}

std::optional<std::int64_t> wholeNumberOf(nb::handle value)
{
	if (switchOf(value)) return std::nullopt;
	const nb::object index = nb::steal(PyNumber_Index(value.ptr()));
	if (index) {
		const long long number = PyLong_AsLongLong(index.ptr());
		if (PyErr_Occurred() == nullptr) return number;
	}
	PyErr_Clear();
	return std::nullopt;
}

std::optional<double> numberOf(nb::handle value)
{
	if (switchOf(value)) return std::nullopt;
	const double number = PyFloat_AsDouble(value.ptr());
	if (PyErr_Occurred() == nullptr) return number;
	PyErr_Clear();
	return std::nullopt;
}

std::optional<std::string> textOf(nb::handle value)
{
	if (!nb::isinstance<nb::str>(value)) return std::nullopt;
	return nb::cast<std::string>(value);
}

ParameterValue parseCount(const Parameter& p, const std::string& name, nb::handle value)
{
	const std::optional<std::int64_t> number = wholeNumberOf(value);
	if (!number || !app::isInRange(p, double(*number)))
		failValue(name, "a whole number" + app::rangeText(p), value);
	return *number;
}

ParameterValue parseNumber(const Parameter& p, const std::string& name, nb::handle value)
{
	if (p.isAutomatic && textOf(value) == automaticName) return Automatic();
	const std::optional<std::string> text = textOf(value);
	if (const auto percent = text ? app::percentOf(p, *text) : std::nullopt) return *percent;
	const std::optional<double> number = numberOf(value);
	if (!number || !app::isInRange(p, *number))
		failValue(name, app::numberKind(p) + app::rangeText(p), value);
	return *number;
}

ParameterValue parseSwitch(const std::string& name, nb::handle value)
{
	const std::optional<bool> isOn = switchOf(value);
	if (!isOn) failValue(name, "True or False", value);
	return *isOn;
}

ParameterValue parseChoice(const Parameter& p, const std::string& name, nb::handle value)
{
	const std::optional<std::string> given = textOf(value);
	std::string                      names;
	for (std::size_t i = 0; i < p.choices.size(); ++i) {
		if (given && *given == p.choices[i]) return std::int64_t(i);
		names += (i > 0 ? ", " : "") + std::string(p.choices[i]);
	}
	failValue(name, "one of " + names, value);
}

ParameterValue parseValue(const Parameter& p, const std::string& name, nb::handle value)
{
	switch (p.kind) {
	case ParameterKind::Count:
		return parseCount(p, name, value);
	case ParameterKind::Number:
	case ParameterKind::Length:
		return parseNumber(p, name, value);
	case ParameterKind::Switch:
		return parseSwitch(name, value);
	case ParameterKind::Choice:
		break;
	}
	return parseChoice(p, name, value);
}

std::string sizeNames(Tool tool)
{
	std::string names;
	for (const Parameter& p : parametersOf(tool)) {
		if (isSizeParameter(p)) names += (names.empty() ? "" : ", ") + app::pythonName(p, tool);
	}
	return names;
}

nb::object defaultOf(const Parameter& p)
{
	if (isSizeParameter(p)) return nb::none();
	if (p.isAutomatic) return nb::str(automaticName);
	const ParameterValue value = p.defaultValue(MeshFacts());
	if (p.kind == ParameterKind::Choice)
		return nb::str(p.choices[std::size_t(std::get<std::int64_t>(value))]);
	if (const auto* count = std::get_if<std::int64_t>(&value)) return nb::cast(*count);
	if (const auto* number = std::get_if<double>(&value)) return nb::cast(*number);
	return nb::cast(std::get<bool>(value));
}

nb::dict entryOf(const Parameter& p, Tool tool)
{
	nb::list choices;
	for (const char* choice : p.choices)
		choices.append(choice);
	nb::dict entry;
	entry["name"]    = app::pythonName(p, tool);
	entry["kind"]    = app::kindName(p.kind);
	entry["label"]   = p.label;
	entry["help"]    = pythonHelp(p);
	entry["about"]   = p.help;
	entry["expert"]  = p.isExpert;
	entry["is_size"] = isSizeParameter(p);
	entry["minimum"] = p.minimum;
	entry["maximum"] = p.maximum;
	entry["choices"] = choices;
	entry["default"] = defaultOf(p);
	return entry;
}

} // namespace

std::optional<bool> switchOf(nb::handle value)
{
	const std::string dtype =
		nb::cast<std::string>(nb::str(nb::getattr(value, "dtype", nb::none())));
	const bool isNumPy = dtype == "bool" && nb::cast<int>(value.attr("ndim")) == 0;
	if (!isNumPy && !nb::isinstance<nb::bool_>(value)) return std::nullopt;
	return nb::cast<bool>(nb::bool_(nb::borrow(value)));
}

nb::list parameterList(Tool tool)
{
	nb::list entries;
	for (const Parameter& p : parametersOf(tool)) {
		if (isArgument(p)) entries.append(entryOf(p, tool));
	}
	return entries;
}

namespace {

/// Whether a value chooses the size of the result; "off" chooses none.
bool choosesSize(const Parameter& p, nb::handle value)
{
	return isSizeParameter(p) && textOf(value) != "off";
}

} // namespace

bool givesSize(Tool tool, const nb::dict& given)
{
	for (const auto& [key, value] : given) {
		const Parameter* const row = findArgument(tool, nb::cast<std::string>(nb::str(key)));
		if (row != nullptr && choosesSize(*row, value)) return true;
	}
	return false;
}

RemeshOptions optionsOf(Tool tool, const nb::dict& given)
{
	ParameterSet set;
	int          sizeNum = 0;
	for (const auto& [key, value] : given) {
		const std::string      name = nb::cast<std::string>(nb::str(key));
		const Parameter* const row  = findArgument(tool, name);
		if (row == nullptr) throw nb::value_error(("There is no parameter " + name + ".").c_str());
		sizeNum += choosesSize(*row, value) ? 1 : 0;
		set.set(*row, parseValue(*row, name, value));
	}
	if (sizeNum > 1) throw nb::value_error(("Give only one of " + sizeNames(tool) + ".").c_str());
	const std::vector<std::string> complaints = set.complaints();
	if (!complaints.empty()) throw nb::value_error(complaints.front().c_str());
	return set.options();
}

} // namespace gpr::python
