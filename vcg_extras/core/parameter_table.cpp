// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_table.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

constexpr double   largestCount = 2147483647.0;
constexpr unsigned sized        = RemeshTool | SamplingTool;
constexpr unsigned shared       = sized | CompareTool;
constexpr unsigned everywhere =
	RemeshTool | SamplingTool | RetriangulateTool | FeatureTool | CompareTool;

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

ParameterValue tenPercent(const MeshFacts& facts)
{
	// A tetrahedron is the smallest closed surface; the dialog never proposes less.
	const std::int64_t whole = facts.hasSelection ? facts.selectedVertexNum : facts.vertexNum;
	// The vertices of the seam stay; as many others beside them make good triangles.
	const double seam  = facts.hasSelection ? 2 * double(facts.seamVertexNum) : 0;
	const double share = std::max(seam, std::round(0.1 * double(whole)));
	return std::int64_t(std::max(4.0, share));
}

template <int value>
ParameterValue count(const MeshFacts&)
{
	return std::int64_t(value);
}

/// Rows are written as a chain of what they have: `row(...).range(...).choices(...)`.
struct Row {
	Parameter p;

	Row& range(double least, double most)
	{
		p.minimum = least;
		p.maximum = most;
		return *this;
	}
	/// Names as on the command line; the first one is the default.
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
	return {{key, option, argument, kind, label, help, 0, 1, {}, zero, nullptr, tools}};
}

using Table = std::vector<Parameter>;
using Kind  = ParameterKind;
using Value = ParameterValue;

void addSamples(Table& t)
{
	t.push_back(row(RetriangulateTool, "SampleLayer", "", "", Kind::Count,
					"Number of the layer with the samples",
					"The layer whose vertices become the vertices of the result, by the number "
					"that MeshLab "
					"shows before its name; the current layer is the surface. The dialog proposes "
					"the newest "
					"other layer of points.")
					.range(0, largestCount)
					.byDefault([](const MeshFacts& facts) { return Value(facts.sampleLayer); })
					.p);
}

void addSize(Table& t)
{
	t.push_back(
		row(shared, "TargetVertexNum", "--vertices", "N", Kind::Count, "Number of vertices",
			"How many vertices the result has, exactly; a sampling lands within about a "
			"tenth of it. Used where percentage and edge length are 0. A number below what "
			"the topology needs is refused, and the "
			"smallest possible one named. Counts those of the selected part where only that is "
			"remeshed. The default is 10 % of the vertices there are.")
			.range(1, largestCount)
			.byDefault(tenPercent)
			.store([](const Value& v, RemeshOptions& o) { o.targetVertexNum = countOf(v); })
			.p);
	t.push_back(row(shared, "TargetPerc", "--percent", "P", Kind::Number,
					"Percentage of vertices (0 = off)",
					"Size of the result in percent of the layer's vertices, in (0, 10000]; takes "
					"the place of the number of vertices where it is above 0. Raised where the "
					"topology needs more vertices.")
					.range(0, 10000)
					.store([](const Value& v, RemeshOptions& o) { o.targetPercent = numberOf(v); })
					.p);
	t.push_back(row(shared, "TargetLen", "--edge-length", "L", Kind::Length,
					"Mean edge length (0 = off)",
					"Wanted mean edge length of the result in mesh units; takes the place of the "
					"number of vertices where it is above 0. Raised count where the topology needs "
					"more vertices.")
					.range(0, 1e300)
					.store([](const Value& v, RemeshOptions& o) { o.targetEdgeLen = numberOf(v); })
					.p);
	t.push_back(
		row(RemeshTool, "MaxError", "--max-error", "E", Kind::Length, "Largest error (0 = off)",
			"Takes the place of the number of vertices where it is above 0: the smallest number is "
			"looked for whose mesh is nowhere farther from the input, nor the input from it; in "
			"mesh units, on the command line also in percent of the diagonal, as 0.2%. Some ten "
			"trials are made. The distance is found by sampling, which is no proof.")
			.range(0, 1e300)
			.store([](const Value& v, RemeshOptions& o) { o.targetMaxError = numberOf(v); })
			.p);
}

void addMainChoices(Table& t)
{
	t.push_back(
		row(shared, "Preset", "--preset", "NAME", Kind::Choice, "Preset",
			"Which way is gone: default, the most regular triangles, close to the input; fast, "
			"three times as fast, without the fit and the passes for regularity; paper, each stage "
			"as the paper has it, whose number of vertices is only "
			"about what was asked for. What is chosen for a single stage wins over the preset.")
			.choices({"default", "fast", "paper"})
			.store([](const Value& v, RemeshOptions& o) { applyPreset(Preset(countOf(v)), o); })
			.p);
	t.push_back(
		row(RemeshTool, "Selected", "--selected", "", Kind::Switch, "Only the selected faces",
			"Remeshes the selected faces and leaves the others bit for bit as they are; the "
			"vertices between the two stay, and the new triangles grow from their spacing to the "
			"wanted size. On by default where faces are selected. On the command line the faces "
			"are those that a PLY file marks by the property 'selected' or MeshLab's 'flags'.")
			.byDefault([](const MeshFacts& facts) { return Value(facts.hasSelection); })
			.store([](const Value& v, RemeshOptions& o) { o.selectedOnly = switchOf(v); })
			.p);
	t.push_back(
		row(shared, "Boundary", "--boundary", "NAME", Kind::Choice, "Boundary",
			"What becomes of the surface's open borders: resample, their curve and their corners "
			"stay, vertices are placed on them anew; keep, every vertex on them stays where it is "
			"and none is added, the triangles growing from their spacing to the wanted size; free, "
			"evenly spaced vertices that cut corners off.")
			.choices({"resample", "keep", "free"})
			.store([](const Value& v, RemeshOptions& o) { o.boundary = BoundaryMode(countOf(v)); })
			.p);
}

void addFeatureLines(Table& t)
{
	t.push_back(
		row(shared, "Features", "--features", "NAME", Kind::Choice, "Feature lines",
			"Sharp edges of the mesh become edges of the result, corners and cone apexes its "
			"vertices: "
			"auto, where they are real creases and not a scan's noise (none with the paper "
			"preset); "
			"lines, wherever the faces turn by the feature angle; off, nowhere; selected, "
			"at the edges selected in MeshLab (no file holds such) and nowhere else. Needs the "
			"retriangulation label-collapse.")
			.choices({"auto", "lines", "off", "selected"})
			.store([](const Value& v, RemeshOptions& o) {
				if (countOf(v) > 0) o.featureMode = FeatureMode(countOf(v));
			})
			.p);
	t.push_back(
		row(shared, "FeatureAngle", "--feature-angle", "DEG", Kind::Number, "Feature angle",
			"A feature line begins where the normals of two faces differ by so many degrees, "
			"and goes on from its ends down to half of that; 5 to 175.")
			.range(5, 175)
			.byDefault([](const MeshFacts&) { return Value(40.0); })
			.store([](const Value& v, RemeshOptions& o) { o.featureAngleDeg = numberOf(v); })
			.p);
}

void addAdaptivity(Table& t)
{
	t.push_back(row(shared, "Adapt", "--adapt", "A", Kind::Number, "Adaptivity to the error",
					"Spends the vertices where the surface bends, for a smaller error at the same "
					"number: 0, all triangles of one size, to 1, sizes within a range of four. Has "
					"no effect with the paper's equations.")
					.range(0, 1)
					.store([](const Value& v, RemeshOptions& o) { o.adapt = numberOf(v); })
					.p);
}

void addLayer(Table& t)
{
	t.push_back(
		row(RemeshTool | RetriangulateTool, "NewLayer", "", "", Kind::Switch,
			"Put the result into a new layer",
			"Off (default): the result takes the place of the layer's mesh, and MeshLab has no "
			"undo. On: it becomes a layer of its own, with the transform of the old one, "
			"which stays as it is.")
			.p);
}

void addComparison(Table& t)
{
	t.push_back(row(CompareTool, "ColorBy", "", "", Kind::Choice, "Colour by",
					"What the two results are coloured by, on one scale: quality, 2 inradius / "
					"circumradius of each face from red (0) over green to blue (1, equilateral); "
					"distance, of each vertex from the input, from blue (0) to red (the largest of "
					"both); nothing. The figure is the quality of the faces or vertices, too.")
					.choices({"quality", "distance", "nothing"})
					.p);
	t.push_back(row(CompareTool, "SideBySide", "", "", Kind::Switch, "Move the results apart",
					"On (default): the transforms of the two layers put them beside the input, "
					"along x. Off: they lie where it is.")
					.byDefault([](const MeshFacts&) { return Value(true); })
					.p);
}

void addStages(Table& t)
{
	t.push_back(row(sized, "Placement", "--placement", "NAME", Kind::Choice, "Placement of samples",
					"Where the next sample is put: disk-intersection, where the borders of two "
					"disks meet (default and fast); border-edge, on a random edge that the border "
					"of the disks crosses (paper).")
					.choices({"preset", "disk-intersection", "border-edge"})
					.store([](const Value& v, RemeshOptions& o) {
						if (countOf(v) > 0) o.placement = Placement(countOf(v) - 1);
					})
					.p);
	t.push_back(row(RemeshTool | RetriangulateTool, "Retriangulation", "--retriangulation", "NAME",
					Kind::Choice, "Retriangulation",
					"How the samples become a mesh: label-collapse merges every vertex into the "
					"cell of its "
					"sample (default and fast); vertex-removal takes the vertices out one by one "
					"and closes "
					"each hole by a constrained Delaunay triangulation (paper).")
					.choices({"preset", "label-collapse", "vertex-removal"})
					.store([](const Value& v, RemeshOptions& o) {
						if (countOf(v) > 0) o.retriangulation = Retriangulation(countOf(v) - 1);
					})
					.p);
	t.push_back(row(RemeshTool, "Smoothing", "--smoothing", "NAME", Kind::Choice, "Smoothing",
					"How vertices move on the surface in the end: barycentric, to the centre of "
					"their neighbours (default and fast); umbrella2, by the second-order umbrella "
					"(paper); none.")
					.choices({"preset", "barycentric", "umbrella2", "none"})
					.store([](const Value& v, RemeshOptions& o) {
						if (countOf(v) > 0) o.smoothing = Smoothing(countOf(v) - 1);
					})
					.p);
	t.push_back(
		row(RemeshTool, "Regularity", "--regularity", "NAME", Kind::Choice, "Regularity",
			"full (default) rids the triangulation of most vertices that have not six neighbours "
			"and makes the triangles equilateral by conformal steps, two for each relaxation step; "
			"plain (fast, paper) only relaxes and flips edges. full is plain where the smoothing "
			"is not barycentric.")
			.choices({"preset", "full", "plain"})
			.store([](const Value& v, RemeshOptions& o) {
				if (countOf(v) > 0) o.regularity = Regularity(countOf(v) - 1);
			})
			.p);
	t.push_back(
		row(RemeshTool, "RelaxIter", "--relax", "K", Kind::Count, "Relaxation steps",
			"How often the vertices are moved by the smoothing, on the surface; 0 to 1000. 3 "
			"make the triangles regular, more change little.")
			.range(0, 1000)
			.byDefault(count<3>)
			.store([](const Value& v, RemeshOptions& o) { o.relaxIterations = int(countOf(v)); })
			.p);
	t.push_back(
		row(RemeshTool, "Fit", "--fit", "on|quick|off", Kind::Choice, "Fit to the input",
			"After the smoothing vertices leave the surface a little for where the triangles lie "
			"closest to it, which halves the error or better, and the triangles stay regular: on "
			"(default); quick, with fewer rounds; off, every vertex stays on the surface (fast, "
			"paper). Vertices of borders and feature lines leave these by at most 8 % of an edge.")
			.choices({"preset", "on", "quick", "off"})
			.store([](const Value& v, RemeshOptions& o) {
				if (countOf(v) > 0) o.fit = Fit(countOf(v) - 1);
			})
			.p);
	t.push_back(
		row(RemeshTool | RetriangulateTool, "FlipIter", "--flips", "K", Kind::Count,
			"Passes of edge flips",
			"Edges are flipped after the retriangulation and while smoothing, in so many passes at "
			"most each time; 0 to 1000. With the default they end by themselves, all edges being "
			"Delaunay.")
			.range(0, 1000)
			.byDefault(count<1000>)
			.store([](const Value& v, RemeshOptions& o) { o.flipIterations = int(countOf(v)); })
			.p);
}

void addCount(Table& t)
{
	t.push_back(
		row(RemeshTool, "ExactCount", "--exact-count", "on|off", Kind::Choice,
			"Exact number of vertices",
			"On (default and fast): edges are split and collapsed after the sampling until the "
			"number of vertices is hit exactly. Off (paper): the number lands within about a tenth "
			"of the target.")
			.choices({"preset", "on", "off"})
			.store([](const Value& v, RemeshOptions& o) {
				if (countOf(v) > 0) o.exactCount = countOf(v) == 1;
			})
			.p);
	t.push_back(row(RemeshTool | CompareTool, "AllowNearest", "--allow-nearest", "", Kind::Switch,
					"Take the nearest possible number",
					"Where the topology needs more vertices than asked for: take the nearest "
					"possible number instead of refusing.")
					.store([](const Value& v, RemeshOptions& o) { o.allowNearest = switchOf(v); })
					.p);
}

void addCleaning(Table& t)
{
	t.push_back(
		row(shared, "DropComponentsBelow", "--drop-components-below", "N", Kind::Count,
			"Drop components with fewer faces (0 = none)",
			"Components with fewer faces are left out: dust of scans, which would take four "
			"vertices a piece. 0 keeps all.")
			.range(0, largestCount)
			.store([](const Value& v, RemeshOptions& o) { o.dropComponentsBelow = countOf(v); })
			.p);
}

void addDensity(Table& t)
{
	t.push_back(
		row(sized, "Equations", "--equations", "NAME", Kind::Choice,
			"Equations of radius and density",
			"Which form of the paper's equations (1), (4) and (5): calibrated, with a constant "
			"that "
			"hits the number, a density without units and its mean over the area (default and "
			"fast); paper, as printed, with 0.844, the mean curvature in 1/mesh unit with its "
			"sign, "
			"and the mean over the vertices.")
			.choices({"preset", "calibrated", "paper"})
			.store([](const Value& v, RemeshOptions& o) {
				if (countOf(v) > 0) o.equations = Equations(countOf(v) - 1);
			})
			.p);
	t.push_back(
		row(sized, "Lambda", "--lambda", "W", Kind::Number, "Curvature weight (lambda)",
			"How much denser curved places are sampled, eq. (4): distances are stretched by "
			"1 + lambda |H| r, where H is the mean curvature and r the disk radius; 0 = evenly, "
			"1 to 5 are usual. With the paper's equations H is taken as it is, in 1/mesh unit.")
			.range(0, 1e6)
			.store([](const Value& v, RemeshOptions& o) { o.lambda = numberOf(v); })
			.p);
	t.push_back(
		row(sized, "MaxStretch", "--max-stretch", "S", Kind::Number, "Largest stretch",
			"The densest places get triangles at most so many times smaller than the largest ones; "
			"1 to 100. Not used with the paper's equations.")
			.range(1, 100)
			.byDefault([](const MeshFacts&) { return Value(4.0); })
			.store([](const Value& v, RemeshOptions& o) { o.largestStretch = numberOf(v); })
			.p);
	t.push_back(
		row(sized, "Sizing", "--sizing", "NAME", Kind::Choice, "Density from",
			"What the density goes with: curvature, or the mesh's vertex quality (on the command "
			"line "
			"the property 'quality' of a PLY file), which then takes the place of |H| r.")
			.choices({"curvature", "quality"})
			.store([](const Value& v, RemeshOptions& o) { o.sizing = SizingSource(countOf(v)); })
			.p);
}

void addFeatures(Table& t)
{
	t.push_back(
		row(sized, "FeatureRegion", "--feature-region", "NAME", Kind::Choice, "Feature region",
			"Which part of the surface is preserved as in the paper's 3.1.1: none; detected, by "
			"the "
			"second-order difference and the thresholds below; selection, the selected vertices "
			"or, where there is none, the corners of selected faces (on the command line by the "
			"property 'flags' of a "
			"PLY "
			"file as MeshLab saves it, or 'selected').")
			.choices({"none", "detected", "selection"})
			.store([](const Value& v, RemeshOptions& o) {
				o.featureRegion = FeatureRegion(countOf(v));
			})
			.p);
	t.push_back(row(sized, "FeatureSampling", "--feature-sampling", "NAME", Kind::Choice,
					"Feature region becomes",
					"How the feature region is preserved: disks, sampled first, with smaller "
					"disks; vertices, each of its vertices stays as a vertex of the result.")
					.choices({"disks", "vertices"})
					.store([](const Value& v, RemeshOptions& o) {
						o.featureSampling = FeatureSampling(countOf(v));
					})
					.p);
	t.push_back(
		row(sized, "FeatureDiskScale", "--feature-disk-scale", "S", Kind::Number,
			"Feature disk scale",
			"Radius of the disks in the feature region over that of the others; 0.05 to 1. Needs a "
			"feature region.")
			.range(0.05, 1)
			.byDefault([](const MeshFacts&) { return Value(0.5); })
			.store([](const Value& v, RemeshOptions& o) { o.featureDiskScale = numberOf(v); })
			.p);
	t.push_back(row(sized | FeatureTool, "FeatureSupport", "--feature-support", "S", Kind::Number,
					"Feature support",
					"Radius within which normals are averaged on either side of an edge for the "
					"second-order difference, in mean edges of the input; above 0, at most 100. "
					"Larger overlooks more noise.")
					.range(0.01, 100)
					.byDefault([](const MeshFacts&) { return Value(2.0); })
					.store([](const Value& v, RemeshOptions& o) {
						o.featureThresholds.support = numberOf(v);
					})
					.p);
	t.push_back(row(sized | FeatureTool, "FeatureStrong", "--feature-strong", "DEG", Kind::Number,
					"Strong feature angle",
					"A feature begins where the normals of the two sides differ by so many "
					"degrees; above 0, at most 180.")
					.range(0.01, 180)
					.byDefault([](const MeshFacts&) { return Value(40.0); })
					.store([](const Value& v, RemeshOptions& o) {
						o.featureThresholds.strongDeg = numberOf(v);
					})
					.p);
	t.push_back(row(sized | FeatureTool, "FeatureWeak", "--feature-weak", "DEG", Kind::Number,
					"Weak feature angle",
					"A feature goes on as long as the normals of the two sides differ by so many "
					"degrees; above 0, at most the strong angle.")
					.range(0.01, 180)
					.byDefault([](const MeshFacts&) { return Value(20.0); })
					.store([](const Value& v, RemeshOptions& o) {
						o.featureThresholds.weakDeg = numberOf(v);
					})
					.p);
	t.push_back(row(sized | FeatureTool, "FeatureLength", "--feature-length", "K", Kind::Number,
					"Least feature length",
					"Features shorter than so many supports are dropped as noise; 0 keeps all.")
					.range(0, 1e6)
					.byDefault([](const MeshFacts&) { return Value(3.0); })
					.store([](const Value& v, RemeshOptions& o) {
						o.featureThresholds.minLength = numberOf(v);
					})
					.p);
}

void addRun(Table& t)
{
	t.push_back(
		row(everywhere, "TimeLimit", "--time-limit", "SECONDS", Kind::Number,
			"Time limit in seconds (0 = none)",
			"Where the work is not done within so many seconds it is given up, and nothing is "
			"changed; 0 = no limit. The commands remesh and features count reading and writing, "
			"too.")
			.range(0, 1e9)
			.store([](const Value& v, RemeshOptions& o) { o.timeLimitSeconds = numberOf(v); })
			.p);
	t.push_back(
		row(shared, "Seed", "--seed", "S", Kind::Count, "Random seed",
			"The same seed gives the same mesh, byte for byte, with any number of threads. 0 takes "
			"a fresh seed and logs it.")
			.range(0, largestCount)
			.byDefault(count<1>)
			.store([](const Value& v, RemeshOptions& o) { o.seed = std::uint32_t(countOf(v)); })
			.p);
	t.push_back(row(everywhere, "Threads", "--threads", "T", Kind::Count, "Threads (0 = all cores)",
					"How many threads work, 0 to 1024; 0 takes one for each core. Never changes "
					"the result.")
					.range(0, 1024)
					.store([](const Value& v, RemeshOptions& o) { o.threads = int(countOf(v)); })
					.p);
	t.push_back(row(RemeshTool | RetriangulateTool, "Check", "--check", "", Kind::Switch,
					"Check thoroughly",
					"Beside what is checked in any case: self-intersections, and the distances "
					"from the input, which costs as much again. Where faces intersect and "
					"none did in the input, or a vertex lies off the input farther than the fit "
					"moved it, there is no result.")
					.store([](const Value& v, RemeshOptions& o) { o.check = switchOf(v); })
					.p);
}

} // namespace

std::vector<Parameter> makeParameterTable()
{
	Table table;
	// What most need comes first, what only experts turn last.
	addSamples(table);
	addSize(table);
	addMainChoices(table);
	addFeatureLines(table);
	addAdaptivity(table);
	addLayer(table);
	addComparison(table);
	addCount(table);
	addCleaning(table);
	addRun(table);
	addStages(table);
	addDensity(table);
	addFeatures(table);
	return table;
}

} // namespace gpr
