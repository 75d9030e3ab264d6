// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_table.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

constexpr double   largestCount = 2147483647.0;
constexpr unsigned sampled      = RemeshTool | SamplingTool;
constexpr unsigned everywhere   = sampled | RetriangulateTool | FeatureTool;

std::int64_t countOf(const ParameterValue& v)
{
	return std::get<std::int64_t>(v);
}

double numberOf(const ParameterValue& v)
{
	return std::get<double>(v);
}

bool switchOf(const ParameterValue& v)
{
	return std::get<bool>(v);
}

std::string withMore(const char* help, const char* more)
{
	return *more == '\0' ? help : std::string(help) + " " + more;
}

ParameterValue tenPercent(const MeshFacts& facts)
{
	// A tetrahedron is the smallest closed surface; the dialog never proposes less.
	return std::int64_t(std::max(4.0, std::round(0.1 * double(facts.vertexNum))));
}

template <int value>
ParameterValue count(const MeshFacts&)
{
	return std::int64_t(value);
}

/// A builder of rows, as a chain: `row(...).range(...).choices(...)`.
struct Row {
	Parameter p;

	Row& range(double least, double most)
	{
		p.minimum = least;
		p.maximum = most;
		return *this;
	}
	/// Names as on the command line; the first name is the default.
	Row& choices(std::vector<const char*> names)
	{
		p.maximum      = double(names.size()) - 1;
		p.choices      = std::move(names);
		p.defaultValue = count<0>;
		return *this;
	}
	Row& byDefault(ParameterValue (*value)(const MeshFacts&))
	{
		p.defaultValue = value;
		return *this;
	}
	Row& automatic()
	{
		p.isAutomatic  = true;
		p.defaultValue = [](const MeshFacts&) { return ParameterValue(Automatic()); };
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
	Row& store(void (*put)(const ParameterValue&, RemeshOptions&))
	{
		p.store = put;
		return *this;
	}
};

Row row(unsigned tools, const char* key, const char* option, const char* argument,
		ParameterKind kind, const char* label, const char* help)
{
	ParameterValue (*zero)(const MeshFacts&) = count<0>;
	if (kind == ParameterKind::Switch)
		zero = [](const MeshFacts&) { return ParameterValue(false); };
	if (kind == ParameterKind::Number || kind == ParameterKind::Length)
		zero = [](const MeshFacts&) { return ParameterValue(0.0); };
	return {{key,
			 option,
			 argument,
			 kind,
			 label,
			 help,
			 "",
			 "",
			 "",
			 0,
			 1,
			 {},
			 zero,
			 nullptr,
			 tools,
			 false,
			 false}};
}

using Table = std::vector<Parameter>;
using Kind  = ParameterKind;
using Value = ParameterValue;

// ---- the number of vertices

void addSize(Table& t)
{
	t.push_back(
		row(sampled, "TargetVertexNum", "--vertices", "N", Kind::Count, "Number of vertices",
			"How many vertices the result has. A remeshing has exactly so many, a sampling about "
			"a tenth more or less. A number below what the topology needs is refused, and the "
			"message names the smallest possible number. Where only the selected faces are "
			"remeshed this is the number of vertices of that part.")
			.inDialog(
				"It counts only while faces, percentage, edge length and largest error are 0. The "
				"proposed number is 10 % of the layer's vertices.")
			.range(1, largestCount)
			.byDefault(tenPercent)
			.store([](const Value& v, RemeshOptions& o) { o.targetVertexNum = countOf(v); })
			.p);
	t.push_back(
		row(RemeshTool, "TargetFaceNum", "--faces", "N", Kind::Count, "Number of faces (0 = off)",
			"How many faces the result has, exactly. A closed surface has an even number, about "
			"twice that of its vertices. A surface with a border has any number, unless all its "
			"border vertices are kept. What the topology does not allow is refused, and the "
			"message names the two nearest numbers that it does.")
			.inDialog("Above 0 it takes the place of the number of vertices.")
			.range(0, largestCount)
			.store([](const Value& v, RemeshOptions& o) { o.targetFaceNum = countOf(v); })
			.p);
	t.push_back(row(sampled, "TargetPerc", "--percent", "P", Kind::Number,
					"Percentage of vertices (0 = off)",
					"The size of the result in percent of the input's vertices, at most 10000. "
					"More vertices are taken where the topology needs them.")
					.inDialog("Above 0 it takes the place of the number of vertices.")
					.range(0, 10000)
					.store([](const Value& v, RemeshOptions& o) { o.targetPercent = numberOf(v); })
					.p);
	t.push_back(row(sampled, "TargetLen", "--edge-length", "L", Kind::Length,
					"Mean edge length (0 = off)",
					"The wanted mean edge length of the result in mesh units. More vertices are "
					"taken where the topology needs them.")
					.inDialog("Above 0 it takes the place of the number of vertices.")
					.range(0, 1e300)
					.store([](const Value& v, RemeshOptions& o) { o.targetEdgeLen = numberOf(v); })
					.p);
	t.push_back(
		row(RemeshTool, "MaxError", "--max-error", "E", Kind::Length, "Largest error (0 = off)",
			"Looks for the smallest number of vertices with which the result is nowhere farther "
			"than this from the input, nor the input from the result. This is proven. It is given "
			"in mesh units. At most five trials are made. The adaptivity is 1 unless another one "
			"is given. Where a trial is too far from the input, more vertices come in. What "
			"cannot be reached is refused.")
			.inDialog("Above 0 it takes the place of the number of vertices.")
			.onCommandLine("With a percent sign, as 0.2%, it is a share of the diagonal.")
			.inPython("As text with a percent sign, as \"0.2%\", it is a share of the diagonal.")
			.range(0, 1e300)
			.store([](const Value& v, RemeshOptions& o) { o.targetMaxError = numberOf(v); })
			.p);
}

// ---- methods and density

void addPreset(Table& t)
{
	t.push_back(
		row(sampled, "Preset", "--preset", "NAME", Kind::Choice, "Preset",
			"Which methods are used. default: the most regular triangles, close to the input: "
			"the fit moves vertices a little off the surface, to where the triangles are closest "
			"to it; those of borders and feature lines leave their curves by at most 8 % of an "
			"edge. fast: a third of the time, without the fit, so that every vertex stays on the "
			"surface, and without the steps for regularity. paper: each stage as the paper "
			"describes it; the number of vertices is hit to a tenth only. A sampling is the same "
			"with "
			"default and fast.")
			.choices({"default", "fast", "paper"})
			.store([](const Value& v, RemeshOptions& o) { o.preset = Preset(countOf(v)); })
			.p);
}

void addDensity(Table& t)
{
	t.push_back(
		row(sampled, "Adapt", "--adapt", "A", Kind::Number, "Adaptivity to the error",
			"How much the sizes of the triangles follow the error. 0: all triangles have "
			"one size. 0.1: a tenth of the vertices goes to ridges, rims and tips that are "
			"finer than the triangles. 1: all sizes follow the error. Sizes stay even where "
			"feature lines take a third of the vertices. auto: 0.1; 1 with a largest error; 0 "
			"with a lambda above 0, in the preset fast, and where only samples are made. The "
			"preset paper has none.")
			.range(0, 1)
			.automatic()
			.store([](const Value& v, RemeshOptions& o) {
				if (const double* given = std::get_if<double>(&v)) o.adapt = *given;
			})
			.p);
	t.push_back(
		row(sampled, "Lambda", "--lambda", "W", Kind::Number, "Curvature weight (lambda)",
			"How much denser curved places are sampled, eq. (4) of the paper. Distances are "
			"stretched by 1 + lambda |H| r, at most 4, where H is the mean curvature and r the "
			"radius of the disks. 0: evenly. 1 to 5 are usual. With the preset paper H is taken "
			"with its sign, in 1/mesh unit, and there is no limit.")
			.range(0, 1e6)
			.store([](const Value& v, RemeshOptions& o) { o.lambda = numberOf(v); })
			.p);
}

// ---- treatment of features and border

void addFeatureLines(Table& t)
{
	t.push_back(
		row(sampled, "Features", "--features", "NAME", Kind::Choice, "Feature lines",
			"Feature lines are sharp edges of the input that become edges of the result; corners "
			"and cone apexes become vertices. auto: real creases, but not the noise of a scan; "
			"none with the preset paper, which never follows any. lines: wherever the faces turn "
			"by the angle of feature lines. off: none. selected: the selected edges and no "
			"others.")
			.onCommandLine(
				"No file format holds selected edges, so that selected is for MeshLab and "
				"Python only.")
			.inPython("The selected edges are those of feature_edges.")
			.choices({"auto", "lines", "off", "selected"})
			.store(
				[](const Value& v, RemeshOptions& o) { o.featureMode = FeatureMode(countOf(v)); })
			.p);
}

void addFeatureDisks(Table& t)
{
	t.push_back(
		row(sampled, "FeatureDiskScale", "--feature-disk-scale", "S", Kind::Number,
			"Feature disk scale (0 = off)",
			"Makes the triangles of the feature region smaller: the radius of its disks over the "
			"radius elsewhere, 0.05 to 1. The feature region is made of the selected vertices; "
			"where no vertex is selected it is detected. 0: no feature region, unless one is "
			"named; then its disks have half the radius. With the preset paper 0 keeps each "
			"vertex of a named region.")
			.inDialog("0.5 is proposed where vertices are selected.")
			.range(0, 1)
			.byDefault(
				[](const MeshFacts& facts) { return Value(facts.hasSelectedVertices ? 0.5 : 0.0); })
			.store([](const Value& v, RemeshOptions& o) { o.featureDiskScale = numberOf(v); })
			.p);
}

void addBoundary(Table& t)
{
	t.push_back(
		row(sampled, "Boundary", "--boundary", "NAME", Kind::Choice, "Boundary",
			"What becomes of the surface's open borders. resample: their curve and their corners "
			"stay, and vertices are placed on them anew. keep: each of their vertices stays where "
			"it is, and none is added; the triangles grow from the spacing there to the wanted "
			"size. free: evenly spaced vertices, which cut corners off. smooth: for the ragged "
			"borders of scans. The border becomes a smooth curve that stays within half an edge "
			"of the scan's border, and corners are rounded. The report tells how much of the "
			"border's length is lost. match: anew, by the border and the edge length alone, so "
			"that meshes with a piece of their borders in common, remeshed one by one with the "
			"same edge length, have the same vertices there, bit for bit.")
			.choices({"resample", "keep", "free", "smooth", "match"})
			.store([](const Value& v, RemeshOptions& o) { o.boundary = BoundaryMode(countOf(v)); })
			.p);
}

void addSelected(Table& t)
{
	t.push_back(
		row(RemeshTool, "Selected", "--selected", "", Kind::Switch, "Only the selected faces",
			"Remeshes the selected faces and leaves all others bit for bit as they are. The "
			"vertices between the two stay. The new triangles grow from the spacing there to the "
			"wanted size.")
			.inDialog("The proposed number of vertices is for the whole layer: give the number "
					  "for the selected part, or an edge length.")
			.onCommandLine("A PLY file marks its selected faces by the property 'selected', or by "
						   "'flags' as MeshLab writes them.")
			.store([](const Value& v, RemeshOptions& o) { o.selectedOnly = switchOf(v); })
			.p);
}

// ---- for experts: the feature region and its detection

void addFeatureRegion(Table& t)
{
	t.push_back(
		row(sampled, "FeatureRegion", "--feature-region", "NAME", Kind::Choice, "Feature region",
			"The part of the surface where vertices are denser, section 3.1.1 of the paper. none: "
			"there is none. detected: what the feature detection finds by the strength of the "
			"edges. selection: the selected vertices, or the corners of the selected faces where "
			"no vertex is selected. auto: the selected vertices, or what is detected where no "
			"vertex is selected, if a feature disk scale is given; else none.")
			.onCommandLine("A PLY file marks its selection by the property 'selected', or by "
						   "'flags' as MeshLab writes them.")
			.inPython("The selected vertices are those of region.")
			.choices({"none", "detected", "selection", "auto"})
			.byDefault(count<3>)
			.store([](const Value& v, RemeshOptions& o) {
				o.featureRegion = FeatureRegion(countOf(v));
			})
			.p);
}

void addFeatureThresholds(Table& t)
{
	t.push_back(
		row(sampled, "FeatureAngle", "--feature-angle", "DEG", Kind::Number,
			"Angle of feature lines",
			"A feature line begins where the normals of two faces differ by so many degrees, 5 to "
			"175. It goes on from its ends down to half of that.")
			.range(5, 175)
			.byDefault([](const MeshFacts&) { return Value(40.0); })
			.store([](const Value& v, RemeshOptions& o) { o.featureAngleDeg = numberOf(v); })
			.p);
	t.push_back(
		row(sampled | FeatureTool, "FeatureSupport", "--feature-support", "S", Kind::Number,
			"Support of the strength",
			"The strength of an edge is the angle between the mean normals of its two sides. The "
			"support is the radius within which normals are averaged, in mean edges of the input; "
			"above 0, at most 100. A larger one overlooks more noise.")
			.range(0.01, 100)
			.byDefault([](const MeshFacts&) { return Value(2.0); })
			.store(
				[](const Value& v, RemeshOptions& o) { o.featureThresholds.support = numberOf(v); })
			.p);
	t.push_back(row(sampled | FeatureTool, "FeatureStrong", "--feature-strong", "DEG", Kind::Number,
					"Strong feature angle",
					"A detected feature begins where the strength has so many degrees; above 0, "
					"at most 180.")
					.range(0.01, 180)
					.byDefault([](const MeshFacts&) { return Value(40.0); })
					.store([](const Value& v, RemeshOptions& o) {
						o.featureThresholds.strongDeg = numberOf(v);
					})
					.p);
	t.push_back(row(sampled | FeatureTool, "FeatureWeak", "--feature-weak", "DEG", Kind::Number,
					"Weak feature angle",
					"A detected feature goes on as long as the strength has so many degrees; "
					"above 0, at most the strong angle.")
					.range(0.01, 180)
					.byDefault([](const MeshFacts&) { return Value(20.0); })
					.store([](const Value& v, RemeshOptions& o) {
						o.featureThresholds.weakDeg = numberOf(v);
					})
					.p);
	t.push_back(row(sampled | FeatureTool, "FeatureLength", "--feature-length", "K", Kind::Number,
					"Least feature length",
					"Detected features that are shorter than so many supports are dropped as "
					"noise. 0 keeps all.")
					.range(0, 1e6)
					.byDefault([](const MeshFacts&) { return Value(3.0); })
					.store([](const Value& v, RemeshOptions& o) {
						o.featureThresholds.minLength = numberOf(v);
					})
					.p);
}

// ---- for experts: the number, the input, the run

void addCount(Table& t)
{
	t.push_back(
		row(RemeshTool, "Detail", "--detail", "NAME", Kind::Choice, "Detail",
			"The number of vertices in words: so many that 99.9 % of the surface is forecast to be "
			"nearer than 1 % of the diagonal (coarse), 0.3 % (normal) or 0.1 % (fine). The number "
			"is "
			"told. It is a forecast: largest error proves a distance, and takes several times as "
			"long. off: the size is given otherwise.")
			.inDialog("It takes the place of the number of vertices.")
			.choices({"off", "coarse", "normal", "fine"})
			.store([](const Value& v, RemeshOptions& o) { o.targetDetail = Detail(countOf(v)); })
			.p);
	t.push_back(
		row(RemeshTool, "AllowNearest", "--allow-nearest", "", Kind::Switch,
			"Take the nearest possible number",
			"Where the topology does not allow the number of vertices or faces that is asked "
			"for, the nearest possible number is taken. Otherwise the run is refused.")
			.store([](const Value& v, RemeshOptions& o) { o.allowNearest = switchOf(v); })
			.p);
}

void addUnits(Table& t)
{
	t.push_back(row(RemeshTool, "MinEdge", "--min-edge", "L", Kind::Length, "Least edge (0 = any)",
					"No edge is wanted shorter than this, in mesh units.")
					.range(0, 1e300)
					.store([](const Value& v, RemeshOptions& o) { o.minEdge = numberOf(v); })
					.p);
	t.push_back(row(RemeshTool, "MaxEdge", "--max-edge", "L", Kind::Length,
					"Largest edge (0 = any)",
					"No edge is wanted longer than this, in mesh units. Where no size is given, "
					"edges are so "
					"long where nothing else makes them shorter, and the number of vertices "
					"follows. Single "
					"edges may be a fifth longer than what is wanted.")
					.range(0, 1e300)
					.store([](const Value& v, RemeshOptions& o) { o.maxEdge = numberOf(v); })
					.p);
	t.push_back(row(RemeshTool, "Growth", "--growth", "G", Kind::Number, "Growth of the edges",
					"How fast lengths may grow from one edge to the next, 1.05 to 2. Faster growth "
					"costs angles.")
					.range(1.05, 2)
					.byDefault([](const MeshFacts&) { return Value(1.15); })
					.store([](const Value& v, RemeshOptions& o) { o.growth = numberOf(v); })
					.p);
}

void addSymmetry(Table& t)
{
	t.push_back(
		row(RemeshTool, "Symmetry", "--symmetry", "NAME", Kind::Choice, "Symmetry",
			"The result is its own mirror image: each vertex has one on the other side of a plane, "
			"with the same coordinates bit for bit but for the one across the plane, and edges run "
			"along the plane. x, y, z: the plane through the middle of the bounding box "
			"perpendicular to that axis. auto: of these planes, or those of the principal axes, "
			"the one that suits best. The input must be symmetric to .1 % of the diagonal, and "
			"is refused otherwise. Half of it is remeshed and mirrored.")
			.choices({"off", "x", "y", "z", "auto"})
			.store([](const Value& v, RemeshOptions& o) { o.symmetry = Symmetry(countOf(v)); })
			.p);
}

void addCleaning(Table& t)
{
	t.push_back(
		row(everywhere, "SewSeams", "--sew", "on|off", Kind::Switch, "Sew seams",
			"Borders that lie on one another edge by edge, within a millionth of the bounding box, "
			"are joined, as those of CAD parts and of games whose smooth patches have vertices of "
			"their own. Where they meet sharply, feature lines run along them. Edges at which more "
			"than two borders meet stay cut. off: the pieces are remeshed one by one.")
			.byDefault([](const MeshFacts&) { return Value(true); })
			.store([](const Value& v, RemeshOptions& o) { o.sew = switchOf(v); })
			.p);
	t.push_back(
		row(RemeshTool, "Junctions", "--junctions", "NAME", Kind::Choice, "Junctions",
			"What becomes of edges with more than two faces, and of places where sheets only "
			"touch. "
			"cut: the smoothest two of the faces stay joined, the others get a border. keep: the "
			"edges are sampled once for all sheets, which share their vertices, as walls between "
			"grains, strata or rooms do.")
			.choices({"cut", "keep"})
			.store([](const Value& v, RemeshOptions& o) { o.junctions = JunctionMode(countOf(v)); })
			.p);
	t.push_back(
		row(sampled, "DropComponentsBelow", "--drop-components-below", "N", Kind::Count,
			"Drop components with fewer faces (0 = none)",
			"Components with fewer faces are left out, for instance the dust of a scan. Each of "
			"them would take four vertices. 0 keeps all.")
			.range(0, largestCount)
			.store([](const Value& v, RemeshOptions& o) { o.dropComponentsBelow = countOf(v); })
			.p);
}

void addRun(Table& t)
{
	t.push_back(
		row(sampled, "Seed", "--seed", "S", Kind::Count, "Random seed",
			"The same seed gives the same mesh, byte for byte, with any number of threads. 0 "
			"takes a new seed and tells it.")
			.range(0, largestCount)
			.byDefault(count<1>)
			.store([](const Value& v, RemeshOptions& o) { o.seed = std::uint32_t(countOf(v)); })
			.p);
	t.push_back(row(everywhere, "Threads", "--threads", "T", Kind::Count, "Threads (0 = all cores)",
					"How many threads work, at most 1024. 0 takes one for each core. The result "
					"is the same.")
					.range(0, 1024)
					.store([](const Value& v, RemeshOptions& o) { o.threads = int(countOf(v)); })
					.p);
	t.push_back(
		row(everywhere, "TimeLimit", "--time-limit", "SECONDS", Kind::Number,
			"Time limit in seconds (0 = none)",
			"A run that takes longer is given up, and nothing is changed. 0 is no limit.")
			.onCommandLine("The commands remesh and features count reading and writing, too.")
			.inPython("The engine's time counts, without the conversion of arrays.")
			.range(0, 1e9)
			.store([](const Value& v, RemeshOptions& o) { o.timeLimitSeconds = numberOf(v); })
			.p);
	t.push_back(row(RemeshTool | RetriangulateTool, "Check", "--check", "", Kind::Switch,
					"Check thoroughly",
					"Looks for self-intersections and measures the distances from the input: root "
					"mean square, p99.9 (99.9 % of the surface is nearer) and the largest, with "
					"proven bounds, in both directions. This takes longer than the run itself. "
					"There is no result where "
					"faces intersect and none did in the input, or where a vertex is farther from "
					"the input than the fit moved it.")
					.store([](const Value& v, RemeshOptions& o) { o.check = switchOf(v); })
					.p);
}

// ---- for experts: parameters of the paper

void addPaperSteps(Table& t)
{
	t.push_back(
		row(RemeshTool, "RelaxIter", "--relax", "K", Kind::Count, "Umbrella steps (paper)",
			"With the preset paper: how often the second-order umbrella operator moves the "
			"vertices, 0 to 1000. Edges are flipped after each step.")
			.range(0, 1000)
			.byDefault(count<3>)
			.store([](const Value& v, RemeshOptions& o) { o.umbrellaSteps = int(countOf(v)); })
			.p);
	t.push_back(
		row(RemeshTool, "FlipIter", "--flips", "K", Kind::Count, "Passes of edge flips (paper)",
			"With the preset paper: edges are flipped in so many passes at most, each time, 0 to "
			"1000. With 1000 they end when all edges are Delaunay, as without that preset.")
			.range(0, 1000)
			.byDefault(count<1000>)
			.store([](const Value& v, RemeshOptions& o) { o.flipPasses = int(countOf(v)); })
			.p);
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
	const std::size_t everydayNum = table.size();
	addFeatureRegion(table);
	addFeatureThresholds(table);
	addCount(table);
	addUnits(table);
	addSymmetry(table);
	addCleaning(table);
	addRun(table);
	addPaperSteps(table);
	for (std::size_t i = everydayNum; i < table.size(); ++i)
		table[i].isExpert = true;
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
