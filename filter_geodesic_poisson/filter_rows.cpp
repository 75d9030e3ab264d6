// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_rows.h"

#include <algorithm>

namespace gpr_filter {

namespace {

using gpr::Parameter;
using gpr::ParameterKind;
using Rows = std::vector<Parameter>;

constexpr double kMostLayers = 2147483647.0;

template <int number>
gpr::ParameterValue count(const gpr::MeshFacts&)
{
	return std::int64_t(number);
}

template <bool isOn>
gpr::ParameterValue state(const gpr::MeshFacts&)
{
	return isOn;
}

Parameter ownRow(const char* key, ParameterKind kind, const char* label, const char* help)
{
	Parameter row    = {};
	row.key          = key;
	row.kind         = kind;
	row.label        = label;
	row.help         = help;
	row.maximum      = 1;
	row.defaultValue = count<0>;
	for (const char** text :
		 {&row.option, &row.argument, &row.dialogOnly, &row.commandOnly, &row.pythonOnly})
		*text = "";
	return row;
}

Parameter sampleLayer()
{
	Parameter row =
		ownRow("SampleLayer", ParameterKind::Count, "Number of the layer with the samples",
			   "The vertices of this layer become the vertices of the result. The "
			   "current layer is the surface. MeshLab shows the number of a layer "
			   "before its name. The proposed layer is the newest other layer of "
			   "points.");
	row.maximum      = kMostLayers;
	row.defaultValue = count<1>;
	return row;
}

Parameter newLayer()
{
	Parameter row    = ownRow("NewLayer", ParameterKind::Switch, "Put the result into a new layer",
							  "Off: the result replaces the mesh of the layer, and MeshLab has no "
								 "undo. On: the result becomes a new layer with the transform of the "
								 "old layer, which stays unchanged.");
	row.defaultValue = state<false>;
	return row;
}

Parameter colorBy()
{
	Parameter row = ownRow("ColorBy", ParameterKind::Choice, "Colour by",
						   "The meaning of the colours of both results, on a common scale. "
						   "quality: 2 inradius / circumradius of each face, from red (0) over "
						   "green to blue (1, equilateral). distance: the distance of each face "
						   "from the input, from blue (0) to red (the largest distance of both). "
						   "The quality of the faces is the same figure.");
	row.choices   = {"quality", "distance", "nothing"};
	row.maximum   = 2;
	return row;
}

Parameter sideBySide()
{
	Parameter row    = ownRow("SideBySide", ParameterKind::Switch, "Move the results apart",
							  "On: the transforms of the two layers put the results beside the input, "
								 "along x. Off: the results lie at the place of the input.");
	row.defaultValue = state<true>;
	return row;
}

/// What MeshLab's dialogs ask beside the engine's options; they stand before those for experts.
Rows ownRowsOf(Filter filter)
{
	switch (filter) {
	case RemeshFilter:
	case RetriangulateFilter:
		return {newLayer()};
	case CompareFilter:
		return {colorBy(), sideBySide()};
	default:
		return {};
	}
}

/// A comparison is of whole meshes, and checks both of its own.
bool isOffered(const Parameter& row, Filter filter)
{
	const std::string key = row.key;
	return filter != CompareFilter || (key != "Selected" && key != "Check");
}

Rows makeRows(Filter filter)
{
	Rows rows;
	if (filter == RetriangulateFilter) rows.push_back(sampleLayer());
	for (const Parameter& row : gpr::parametersOf(toolOf(filter))) {
		if (isOffered(row, filter)) rows.push_back(row);
	}
	const Rows own = ownRowsOf(filter);
	const auto first =
		std::find_if(rows.begin(), rows.end(), [](const Parameter& row) { return row.isExpert; });
	rows.insert(first, own.begin(), own.end());
	return rows;
}

} // namespace

gpr::Tool toolOf(Filter filter)
{
	return filter == CompareFilter ? gpr::RemeshTool : gpr::Tool(filter);
}

const Rows& rowsOf(Filter filter)
{
	static const std::map<Filter, Rows> all = [] {
		std::map<Filter, Rows> made;
		for (Filter one :
			 {RemeshFilter, SamplingFilter, RetriangulateFilter, FeatureFilter, CompareFilter})
			made[one] = makeRows(one);
		return made;
	}();
	return all.at(filter);
}

const Parameter& remeshRow(const std::string& key)
{
	const Rows& rows = rowsOf(RemeshFilter);
	return *std::find_if(rows.begin(), rows.end(),
						 [&](const Parameter& row) { return key == row.key; });
}

std::string dialogLabel(const Parameter& row)
{
	return std::string(row.label) + (row.isAutomatic ? " (-1 = auto)" : "");
}

} // namespace gpr_filter
