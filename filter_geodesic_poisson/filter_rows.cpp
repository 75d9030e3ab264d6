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

/// A row of MeshLab's own with named choices; the first choice is the default.
Parameter choiceRow(const char* key, const char* label, const char* help,
					decltype(Parameter::choices) choices)
{
	Parameter row = ownRow(key, ParameterKind::Choice, label, help);
	row.maximum   = double(choices.size()) - 1;
	row.choices   = std::move(choices);
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

Parameter regions()
{
	return choiceRow("Regions", "Regions",
					 "The attribute of faces with the labels of regions, such as materials or "
					 "patches. Edges of the result follow region borders, and the faces of the "
					 "result get the labels. off: no regions. texture: the index of the "
					 "texture. colour: the colour of the faces; each colour is a region. "
					 "quality: the quality of the faces, in whole numbers.",
					 {"off", "texture", "colour", "quality"});
}

Parameter qualitySizes()
{
	return choiceRow("QualitySizes", "Sizes from the vertex quality",
					 "Use of the vertex quality as wanted edge length. off: no use. exact: "
					 "the quality is the length in mesh units, and decides the number of "
					 "vertices; no other size may be given. scaled: one factor scales all lengths "
					 "to the wanted number of vertices or other size. The quality must be above 0.",
					 {"off", "exact", "scaled"});
}

Parameter period(const char* key, const char* label)
{
	Parameter row    = ownRow(key, ParameterKind::Length, label,
							  "The length of a periodic cell along this axis, in mesh units. Vertices "
								 "of opposite borders match, one length apart. Opposite borders "
								 "with different shapes are refused. 0: no period.");
	row.maximum      = 1e300;
	row.defaultValue = [](const gpr::MeshFacts&) { return gpr::ParameterValue(0.0); };
	return row;
}

Rows expertRowsOf(Filter filter)
{
	if (filter != RemeshFilter) return {};
	Rows rows = {qualitySizes(), period("PeriodX", "Period along x (0 = none)"),
				 period("PeriodY", "Period along y (0 = none)"),
				 period("PeriodZ", "Period along z (0 = none)")};
	for (Parameter& row : rows)
		row.isExpert = true;
	return rows;
}

Parameter colorBy()
{
	return choiceRow("ColorBy", "Colour by",
					 "The meaning of the colours of both results, on a common scale. "
					 "quality: 2 inradius / circumradius of each face, from red (0) over "
					 "green to blue (1, equilateral). distance: the distance of each face "
					 "from the input, from blue (0) to red (the largest distance of both). "
					 "The quality of the faces is the same figure.",
					 {"quality", "distance", "nothing"});
}

Parameter sideBySide()
{
	Parameter row    = ownRow("SideBySide", ParameterKind::Switch, "Move the results apart",
							  "On: the transforms of the two layers put the results beside the input, "
								 "along x. Off: the results lie at the place of the input.");
	row.defaultValue = state<true>;
	return row;
}

/// The rows of MeshLab's dialogs beside the engine's options, before the rows for experts.
Rows ownRowsOf(Filter filter)
{
	switch (filter) {
	case RemeshFilter:
		return {newLayer(), regions()};
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
	Rows       own        = ownRowsOf(filter);
	const Rows forExperts = expertRowsOf(filter);
	own.insert(own.end(), forExperts.begin(), forExperts.end());
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
