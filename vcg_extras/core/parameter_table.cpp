// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_table.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace gpr {

namespace {

constexpr double   largestCount = 2147483647.0;
constexpr unsigned sampled      = RemeshTool | SamplingTool;
constexpr unsigned everywhere   = sampled | RetriangulateTool | FeatureTool;

using Table = std::vector<Parameter>;
using Kind  = ParameterKind;
using Value = ParameterValue;

std::string withMore(const char* help, const char* more)
{
	return *more == '\0' ? help : std::string(help) + " " + more;
}

Value tenPercent(const MeshFacts& facts)
{
	// A tetrahedron is the smallest closed surface; the dialog never proposes less.
	return std::int64_t(std::max(4.0, std::round(0.1 * double(facts.vertexNum))));
}

/// A member of the options, or a member of this member.
template <auto... member>
auto& memberOf(RemeshOptions& o)
{
	return (o.*....*member);
}

/// The type in a ParameterValue for an option. A choice is a whole number, too.
template <class Option>
using Stored = std::conditional_t<std::is_same_v<Option, bool> || std::is_same_v<Option, double>,
								  Option, std::int64_t>;

template <auto... member>
void store(const Value& v, RemeshOptions& o)
{
	auto& option = memberOf<member...>(o);
	using Option = std::decay_t<decltype(option)>;
	option       = Option(std::get<Stored<Option>>(v));
}

/// The value that the options have without the row.
template <auto... member>
Value usual(const MeshFacts&)
{
	RemeshOptions o;
	const auto    option = memberOf<member...>(o);
	return Stored<std::decay_t<decltype(option)>>(option);
}

/// Stores a length, and whether it is in percent of the diagonal.
template <auto length, auto isPercent>
void storeLength(const Value& v, RemeshOptions& o)
{
	const auto* percent = std::get_if<PercentOfDiagonal>(&v);
	o.*isPercent        = percent != nullptr;
	o.*length           = percent != nullptr ? percent->value : std::get<double>(v);
}

/// Fills in a row of the table, as a chain: `row(...).range(...).sets<...>()`.
struct Row {
	Parameter& p;

	Row& range(double least, double most)
	{
		p.minimum = least;
		p.maximum = most;
		return *this;
	}
	/// Names as on the command line, in the order of the enumeration.
	Row& choices(std::vector<const char*> names)
	{
		p.maximum = double(names.size()) - 1;
		p.choices = std::move(names);
		return *this;
	}
	/// The option of the row, with the default of the options.
	template <auto... member>
	Row& sets()
	{
		p.store        = store<member...>;
		p.defaultValue = usual<member...>;
		return *this;
	}
	template <auto length, auto isPercent>
	Row& setsLength()
	{
		p.store        = storeLength<length, isPercent>;
		p.defaultValue = usual<length>;
		return *this;
	}
	/// A number that the engine chooses by default.
	Row& automatic(void (*put)(const Value&, RemeshOptions&))
	{
		p.isAutomatic  = true;
		p.store        = put;
		p.defaultValue = [](const MeshFacts&) { return Value(Automatic()); };
		return *this;
	}
	/// A default that differs from the default in the options.
	Row& byDefault(Value (*value)(const MeshFacts&))
	{
		p.defaultValue = value;
		return *this;
	}
	Row& inDialog(const char* sentences)
	{
		p.dialogOnly = sentences;
		return *this;
	}
	Row& onCommandLine(const char* sentences)
	{
		p.commandOnly = sentences;
		return *this;
	}
	Row& inPython(const char* sentences)
	{
		p.pythonOnly = sentences;
		return *this;
	}
};

/// Adds a row to the table.
Row row(Table& t, unsigned tools, const char* key, const char* option, const char* argument,
		Kind kind, const char* label, const char* help)
{
	Parameter p{key, option, argument, kind, label, help};
	p.tools = tools;
	if (kind == Kind::Length) {
		p.commandOnly = "With a percent sign (0.2%) the value is a share of the diagonal.";
		p.pythonOnly  = "A text with a percent sign (\"0.2%\") is a share of the diagonal.";
	}
	t.push_back(std::move(p));
	return {t.back()};
}

// ---- the number of vertices

void addSize(Table& t)
{
	row(t, sampled, "TargetVertexNum", "--vertices", "N", Kind::Count, "Number of vertices",
		"The number of vertices of the result: exact for a remeshing. A sampling is about a tenth "
		"off on closed surfaces with some hundred vertices, and more with fewer vertices, with a "
		"varying density, and if borders, components or feature lines need samples of their own; a "
		"note tells the difference. If the topology needs more vertices, the run is refused, and "
		"the message names the "
		"smallest possible number. If only the selected faces are remeshed, the number counts the "
		"vertices of this part.")
		.inDialog("Used only while faces, percentage, edge length and largest error are 0. The "
				  "proposed number is 10 % of the vertices of the layer.")
		.range(1, largestCount)
		.sets<&RemeshOptions::targetVertexNum>()
		.byDefault(tenPercent);
	row(t, RemeshTool, "TargetFaceNum", "--faces", "N", Kind::Count, "Number of faces (0 = off)",
		"The exact number of faces of the result. A closed surface has an even number, about twice "
		"the number of vertices. A surface with a border can have any number, unless all border "
		"vertices are kept. If the topology does not allow the number, the run is refused, and the "
		"message names the two nearest possible numbers.")
		.inDialog("Above 0 it replaces the number of vertices.")
		.range(0, largestCount)
		.sets<&RemeshOptions::targetFaceNum>();
	row(t, sampled, "TargetPerc", "--percent", "P", Kind::Number,
		"Percentage of vertices (0 = off)",
		"The number of vertices in percent of the input's vertices, at most 10000. If the topology "
		"needs more vertices, the result has more.")
		.inDialog("Above 0 it replaces the number of vertices.")
		.range(0, 10000)
		.sets<&RemeshOptions::targetPercent>()
		.byDefault([](const MeshFacts&) { return Value(0.0); });
	row(t, sampled, "TargetLen", "--edge-length", "L", Kind::Length, "Mean edge length (0 = off)",
		"The wanted mean edge length of the result in mesh units. If the topology needs more "
		"vertices, the result has more.")
		.inDialog("Above 0 it replaces the number of vertices.")
		.range(0, 1e300)
		.setsLength<&RemeshOptions::targetEdgeLen, &RemeshOptions::edgeLenIsPercent>();
	row(t, RemeshTool, "MaxError", "--max-error", "E", Kind::Length, "Largest error (0 = off)",
		"Searches the smallest number of vertices with a proven largest distance between result "
		"and input, in both directions, of at most this length in mesh units. The search makes at "
		"most five trials. The adaptivity is 1 unless another value is given. If a trial is too "
		"far from the input, vertices are added. An impossible error is refused.")
		.inDialog("Above 0 it replaces the number of vertices.")
		.range(0, 1e300)
		.setsLength<&RemeshOptions::targetMaxError, &RemeshOptions::maxErrorIsPercent>();
}

// ---- methods and density

void addPreset(Table& t)
{
	row(t, sampled, "Preset", "--preset", "NAME", Kind::Choice, "Preset",
		"The methods of a run. default: the most regular triangles, close to the input. The fit "
		"moves vertices a little off the surface to reduce the distance; vertices of borders and "
		"feature lines leave their curves by at most 8 % of an edge. fast: less than half the "
		"time, without the steps for regularity; one step raises each vertex over its neighbours "
		"in place of the fit. paper: each stage as in the paper; every vertex stays on the "
		"surface, and the number of vertices is not exact: about a tenth off on closed surfaces, "
		"more with borders and many components; a note tells the difference. A sampling is the "
		"same with default and fast.")
		.choices({"default", "fast", "paper"})
		.sets<&RemeshOptions::preset>();
}

void addDensity(Table& t)
{
	row(t, sampled, "Adapt", "--adapt", "A", Kind::Number, "Adaptivity to the error",
		"Adaptivity of the local sizes to the error. 0: all triangles have one size. 0.1: a tenth "
		"of the vertices goes to ridges, rims and tips that are finer than the triangles. 1: all "
		"sizes follow the error. If feature lines take a third of the vertices, the sizes stay "
		"even. auto: 0.1; 1 with a largest error; 0 with a lambda above 0, with the preset fast, "
		"and for a sampling alone. The preset paper has no adaptivity.")
		.range(0, 1)
		.automatic([](const Value& v, RemeshOptions& o) {
			if (const double* given = std::get_if<double>(&v)) o.adapt = *given;
		});
	row(t, sampled, "Lambda", "--lambda", "W", Kind::Number, "Curvature weight (lambda)",
		"Additional density at curved places, eq. (4) of the paper. Distances are stretched by 1 + "
		"lambda |H| r, at most 4; H is the mean curvature and r the radius of the disks. 0: even "
		"density. Usual values are 1 to 5. The preset paper takes H with its sign, in 1/mesh unit, "
		"without a limit.")
		.range(0, 1e6)
		.sets<&RemeshOptions::lambda>();
}

// ---- treatment of features and border

void addFeatureLines(Table& t)
{
	row(t, sampled, "Features", "--features", "NAME", Kind::Choice, "Feature lines",
		"Feature lines are crease edges of the input that become edges of the result; corners and "
		"cone apexes become vertices. auto: clear crease edges, but not the noise of a scan; none "
		"with the preset paper, which never follows lines. lines: all edges above the angle of "
		"feature lines. off: none. selected: only the selected edges.")
		.onCommandLine(
			"No file format holds selected edges, so selected works in MeshLab and Python only.")
		.inPython("feature_edges lists the selected edges.")
		.choices({"auto", "lines", "off", "selected"})
		.sets<&RemeshOptions::featureMode>();
}

void addFeatureDisks(Table& t)
{
	row(t, sampled, "FeatureDiskScale", "--feature-disk-scale", "S", Kind::Number,
		"Feature disk scale (0 = off)",
		"Makes the triangles of the feature region smaller: the radius of the disks in the region, "
		"divided by the radius elsewhere, 0.05 to 1. The selected vertices are the feature region; "
		"if no vertex is selected, the region is detected. 0: no feature region, unless the option "
		"feature region names one; then its disks have half the radius. With the preset paper 0 "
		"keeps each vertex of a named region.")
		.inDialog("0.5 is proposed if vertices are selected.")
		.range(0, 1)
		.sets<&RemeshOptions::featureDiskScale>()
		.byDefault(
			[](const MeshFacts& facts) { return Value(facts.hasSelectedVertices ? 0.5 : 0.0); });
}

void addBoundary(Table& t)
{
	row(t, sampled, "Boundary", "--boundary", "NAME", Kind::Choice, "Border",
		"Treatment of the borders of the surface. resample: the curves and corners of the border "
		"stay, with new vertices. keep: each border vertex stays, and no vertex is added; the "
		"triangles grow from the spacing there to the wanted size. free: evenly spaced vertices, "
		"which cut corners off. smooth: for the ragged borders of scans; the border becomes a "
		"smooth curve within half an edge of the old border, corners are rounded, and the report "
		"tells the lost length. match: the vertices depend on the border and the edge length only; "
		"meshes with a common piece of border get the same vertices there, bit for bit, in "
		"separate runs with the same edge length.")
		.choices({"resample", "keep", "free", "smooth", "match"})
		.sets<&RemeshOptions::boundary>();
}

void addSelected(Table& t)
{
	row(t, RemeshTool, "Selected", "--selected", "", Kind::Switch, "Only the selected faces",
		"Remeshes the selected faces only; all other faces stay bit for bit. The vertices between "
		"both parts and on borders stay. The new triangles grow from the spacing there to the "
		"wanted size.")
		.inDialog("The proposed number of vertices is for the whole layer: give the number for "
				  "the selected part, or an edge length.")
		.onCommandLine(
			"A PLY file marks its selected faces by the property 'selected', or by 'flags' as in "
			"MeshLab.")
		.sets<&RemeshOptions::selectedOnly>();
}

// ---- for experts: the feature region and its detection

void addFeatureRegion(Table& t)
{
	row(t, sampled, "FeatureRegion", "--feature-region", "NAME", Kind::Choice, "Feature region",
		"The part of the surface with denser vertices, section 3.1.1 of the paper. none: no "
		"region. detected: the region of the feature detection, by the strength of the edges. "
		"selection: the selected vertices; if no vertex is selected, the corners of the selected "
		"faces. auto: with a feature disk scale, the selected vertices, or the detected region if "
		"no vertex is selected; otherwise none.")
		.onCommandLine(
			"A PLY file marks its selection by the property 'selected', or by 'flags' as in "
			"MeshLab.")
		.inPython("region marks the selected vertices.")
		.choices({"none", "detected", "selection", "auto"})
		.sets<&RemeshOptions::featureRegion>();
}

void addFeatureThresholds(Table& t)
{
	row(t, sampled, "FeatureAngle", "--feature-angle", "DEG", Kind::Number,
		"Angle of feature lines",
		"A feature line begins at edges whose faces differ by this angle in degrees, 5 to 175, and "
		"continues from its ends down to half of the angle.")
		.range(5, 175)
		.sets<&RemeshOptions::featureAngleDeg>();
	row(t, sampled | FeatureTool, "FeatureSupport", "--feature-support", "S", Kind::Number,
		"Support of the strength",
		"The strength of an edge is the angle between the mean normals of its two sides. The "
		"support is the radius of the averages, in mean edges of the input; above 0, at most 100. "
		"A larger support suppresses more noise.")
		.range(0.01, 100)
		.sets<&RemeshOptions::featureThresholds, &FeatureThresholds::support>();
	row(t, sampled | FeatureTool, "FeatureStrong", "--feature-strong", "DEG", Kind::Number,
		"Strong feature angle",
		"A detected feature begins at a strength of this angle in degrees; above 0, at most 180.")
		.range(0.01, 180)
		.sets<&RemeshOptions::featureThresholds, &FeatureThresholds::strongDeg>();
	row(t, sampled | FeatureTool, "FeatureWeak", "--feature-weak", "DEG", Kind::Number,
		"Weak feature angle",
		"A detected feature continues down to a strength of this angle in degrees; above 0, at "
		"most the strong angle.")
		.range(0.01, 180)
		.sets<&RemeshOptions::featureThresholds, &FeatureThresholds::weakDeg>();
	row(t, sampled | FeatureTool, "FeatureLength", "--feature-length", "K", Kind::Number,
		"Least feature length",
		"Detected features shorter than this number of supports are dropped as noise. 0 keeps all "
		"features.")
		.range(0, 1e6)
		.sets<&RemeshOptions::featureThresholds, &FeatureThresholds::minLength>();
}

// ---- for experts: the number, the input, the run

void addCount(Table& t)
{
	row(t, RemeshTool, "Detail", "--detail", "NAME", Kind::Choice, "Detail",
		"The number of vertices in words: 99.9 % of the surface is expected to be nearer than 1 % "
		"of the diagonal (coarse), 0.3 % (normal) or 0.1 % (fine). The program tells the number. "
		"This is a forecast; the largest error proves a distance, and takes several times as long. "
		"off: another option sets the size.")
		.inDialog("It replaces the number of vertices.")
		.choices({"off", "coarse", "normal", "fine"})
		.sets<&RemeshOptions::targetDetail>();
	row(t, RemeshTool, "AllowNearest", "--allow-nearest", "", Kind::Switch,
		"Take the nearest possible number",
		"If the topology does not allow the wanted number of vertices or faces, the nearest "
		"possible number is taken. Otherwise the run is refused.")
		.sets<&RemeshOptions::allowNearest>();
}

void addUnits(Table& t)
{
	row(t, RemeshTool, "MinEdge", "--min-edge", "L", Kind::Length, "Least edge (0 = any)",
		"The smallest local size, in mesh units.")
		.range(0, 1e300)
		.setsLength<&RemeshOptions::minEdge, &RemeshOptions::minEdgeIsPercent>();
	row(t, RemeshTool, "MaxEdge", "--max-edge", "L", Kind::Length, "Largest edge (0 = any)",
		"The largest local size, in mesh units. Without a size of the result, this is the size of "
		"all places that nothing else makes smaller, and decides the number of vertices. A local "
		"size is a mean: about a tenth of the edges are more than a fifth longer, single edges "
		"twice as long or more.")
		.range(0, 1e300)
		.setsLength<&RemeshOptions::maxEdge, &RemeshOptions::maxEdgeIsPercent>();
	row(t, RemeshTool, "Growth", "--growth", "G", Kind::Number, "Growth of the edges",
		"The largest ratio of the lengths of neighbouring edges, 1.05 to 2. Faster growth costs "
		"angles.")
		.range(1.05, 2)
		.sets<&RemeshOptions::growth>();
}

void addSymmetry(Table& t)
{
	row(t, RemeshTool, "Symmetry", "--symmetry", "NAME", Kind::Choice, "Symmetry",
		"The result is its own mirror image: each vertex has an image across a plane with the same "
		"coordinates bit for bit, except the mirrored coordinate, and edges run along the plane. "
		"x, y, z: the plane through the middle of the bounding box, perpendicular to this axis. "
		"auto: the best of these planes and of the planes of the principal axes. The input must be "
		"symmetric to .1 % of the diagonal; otherwise the run is refused. Half of the input is "
		"remeshed and mirrored.")
		.choices({"off", "x", "y", "z", "auto"})
		.sets<&RemeshOptions::symmetry>();
}

void addCleaning(Table& t)
{
	row(t, everywhere, "SewSeams", "--sew", "on|off", Kind::Switch, "Sew seams",
		"Joins borders that coincide edge by edge, within a millionth of the bounding box. CAD "
		"parts, and games whose smooth patches have separate vertices, have such borders. Feature "
		"lines run along sharp seams. Edges with more than two borders stay cut. off: the pieces "
		"stay separate.")
		.sets<&RemeshOptions::sew>();
	row(t, RemeshTool, "Junctions", "--junctions", "NAME", Kind::Choice, "Junctions",
		"Treatment of edges with more than two faces, and of places at which sheets only touch. "
		"cut: the smoothest two of the faces stay joined, the other faces get a border. keep: the "
		"edges are sampled once for all sheets, which share their vertices, such as walls between "
		"grains, strata or rooms.")
		.choices({"cut", "keep"})
		.sets<&RemeshOptions::junctions>();
	row(t, sampled, "DropComponentsBelow", "--drop-components-below", "N", Kind::Count,
		"Drop components with fewer faces (0 = none)",
		"Components with fewer faces are left out, for instance the dust of a scan. Each such "
		"component would take four vertices. 0 keeps all components.")
		.range(0, largestCount)
		.sets<&RemeshOptions::dropComponentsBelow>();
}

void addRun(Table& t)
{
	row(t, sampled, "Seed", "--seed", "S", Kind::Count, "Random seed",
		"The same seed gives the same mesh, byte for byte, with any number of threads. 0 takes a "
		"new seed; the report names the seed.")
		.range(0, largestCount)
		.sets<&RemeshOptions::seed>();
	row(t, everywhere, "Threads", "--threads", "T", Kind::Count, "Threads (0 = all cores)",
		"The number of threads, at most 1024. 0 takes one for each core. The result is the same.")
		.range(0, 1024)
		.sets<&RemeshOptions::threads>();
	row(t, everywhere, "TimeLimit", "--time-limit", "SECONDS", Kind::Number,
		"Time limit in seconds (0 = none)",
		"A run that takes longer ends without a result and changes nothing. 0 is no limit.")
		.onCommandLine("The commands remesh and features also count reading and writing.")
		.inPython("The limit counts the time of the engine, without the conversion of arrays.")
		.range(0, 1e9)
		.sets<&RemeshOptions::timeLimitSeconds>();
	row(t, RemeshTool | RetriangulateTool, "Check", "--check", "", Kind::Switch, "Check thoroughly",
		"Searches self-intersections and measures the distances from the input: root mean square, "
		"p99.9 (99.9 % of the surface is nearer) and the largest, with proven bounds, in both "
		"directions. This takes longer than the run itself. A result is withheld if faces "
		"intersect at places without intersections of the input, or if a vertex is farther from "
		"the input than the move of the fit.")
		.sets<&RemeshOptions::check>();
}

// ---- for experts: parameters of the paper

void addPaperSteps(Table& t)
{
	row(t, RemeshTool, "RelaxIter", "--relax", "K", Kind::Count, "Umbrella steps (paper)",
		"With the preset paper: the number of moves of the vertices by the second-order umbrella "
		"operator, 0 to 1000. Edges are flipped after each move.")
		.range(0, 1000)
		.sets<&RemeshOptions::umbrellaSteps>();
	row(t, RemeshTool, "FlipIter", "--flips", "K", Kind::Count, "Passes of edge flips (paper)",
		"With the preset paper: the largest number of passes of edge flips, each time, 0 to 1000. "
		"With 1000 the passes end when all edges are Delaunay, as without this preset.")
		.range(0, 1000)
		.sets<&RemeshOptions::flipPasses>();
}

/// Adds rows for experts.
void addGroup(Table& t, const char* group, std::initializer_list<void (*)(Table&)> rows)
{
	const std::size_t first = t.size();
	for (void (*add)(Table&) : rows)
		add(t);
	for (std::size_t i = first; i < t.size(); ++i) {
		t[i].isExpert = true;
		t[i].group    = group;
	}
}

} // namespace

std::vector<Parameter> makeParameterTable()
{
	Table table;
	// In the order in which a user decides.
	addSize(table);
	addPreset(table);
	addDensity(table);
	addFeatureLines(table);
	addFeatureDisks(table);
	addBoundary(table);
	addSelected(table);
	addGroup(table, "Feature region and feature lines", {addFeatureRegion, addFeatureThresholds});
	addGroup(table, "Number of vertices and local size", {addCount, addUnits});
	addGroup(table, "Input mesh", {addSymmetry, addCleaning});
	addGroup(table, "Run", {addRun});
	addGroup(table, "Preset paper", {addPaperSteps});
	return table;
}

std::string dialogHelp(const Parameter& p)
{
	return withMore(p.help, p.dialogOnly);
}

std::string commandHelp(const Parameter& p)
{
	return withMore(p.help, p.commandOnly);
}

std::string pythonHelp(const Parameter& p)
{
	return withMore(p.help, p.pythonOnly);
}

} // namespace gpr
