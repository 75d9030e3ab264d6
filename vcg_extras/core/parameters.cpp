// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

constexpr double largestCount = 2147483647.0;

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
	const double share = std::round(0.1 * double(facts.vertexNum));
	return std::int64_t(std::max(4.0, share));
}

void storeVertexNum(const ParameterValue& v, RemeshOptions& o)
{
	o.targetVertexNum = countOf(v);
}

void storePercent(const ParameterValue& v, RemeshOptions& o)
{
	o.targetPercent = numberOf(v);
}

void storeEdgeLen(const ParameterValue& v, RemeshOptions& o)
{
	o.targetEdgeLen = numberOf(v);
}

std::vector<Parameter> makeTable()
{
	std::vector<Parameter> t;
	t.push_back({"TargetVertexNum",
				 "--vertices",
				 "N",
				 ParameterKind::Count,
				 "Number of vertices",
				 "How many vertices the result has, exactly. Used where percentage and edge length "
				 "are 0. A number below what the topology needs is refused, and the smallest "
				 "possible one named. The default is 10 % of the layer's vertices.",
				 1,
				 largestCount,
				 {},
				 tenPercent,
				 storeVertexNum});
	t.push_back({"TargetPerc",
				 "--percent",
				 "P",
				 ParameterKind::Number,
				 "Percentage of vertices (0 = off)",
				 "Size of the result in percent of the layer's vertices, in (0, 10000]; takes the "
				 "place of the number of vertices where it is above 0. Raised where the topology "
				 "needs more vertices.",
				 0,
				 10000,
				 {},
				 [](const MeshFacts&) { return ParameterValue(0.0); },
				 storePercent});
	t.push_back({"TargetLen",
				 "--edge-length",
				 "L",
				 ParameterKind::Length,
				 "Mean edge length (0 = off)",
				 "Wanted mean edge length of the result in mesh units; takes the place of the "
				 "number of vertices where it is above 0. Raised count where the topology needs "
				 "more vertices.",
				 0,
				 1e300,
				 {},
				 [](const MeshFacts&) { return ParameterValue(0.0); },
				 storeEdgeLen});
	t.push_back(
		{"RelaxIter",
		 "--relax",
		 "K",
		 ParameterKind::Count,
		 "Relaxation steps",
		 "How often the vertices are moved towards the centre of their neighbours, on the "
		 "surface; 0 to 1000. 3 to 5 make the triangles regular, more change little.",
		 0,
		 1000,
		 {},
		 [](const MeshFacts&) { return ParameterValue(std::int64_t(5)); },
		 [](const ParameterValue& v, RemeshOptions& o) { o.relaxIterations = int(countOf(v)); }});
	t.push_back(
		{"ExactCount",
		 "--exact-count",
		 "on|off",
		 ParameterKind::Switch,
		 "Exact number of vertices",
		 "Splits and collapses edges after the sampling until the number of vertices is hit "
		 "exactly. Off: the number lands within about a tenth of the target.",
		 0,
		 1,
		 {},
		 [](const MeshFacts&) { return ParameterValue(true); },
		 [](const ParameterValue& v, RemeshOptions& o) { o.exactCount = switchOf(v); }});
	t.push_back({"AllowNearest",
				 "--allow-nearest",
				 "",
				 ParameterKind::Switch,
				 "Take the nearest possible number",
				 "Where the topology needs more vertices than asked for: take the nearest possible "
				 "number instead of refusing.",
				 0,
				 1,
				 {},
				 [](const MeshFacts&) { return ParameterValue(false); },
				 [](const ParameterValue& v, RemeshOptions& o) { o.allowNearest = switchOf(v); }});
	t.push_back(
		{"Seed",
		 "--seed",
		 "S",
		 ParameterKind::Count,
		 "Random seed",
		 "The same seed gives the same mesh, byte for byte, with any number of threads. 0 "
		 "takes a fresh seed and logs it.",
		 0,
		 largestCount,
		 {},
		 [](const MeshFacts&) { return ParameterValue(std::int64_t(1)); },
		 [](const ParameterValue& v, RemeshOptions& o) { o.seed = std::uint32_t(countOf(v)); }});
	t.push_back({"Threads",
				 "--threads",
				 "T",
				 ParameterKind::Count,
				 "Threads (0 = all cores)",
				 "How many threads work, 0 to 1024; 0 takes one for each core. Never changes the "
				 "result.",
				 0,
				 1024,
				 {},
				 [](const MeshFacts&) { return ParameterValue(std::int64_t(0)); },
				 [](const ParameterValue& v, RemeshOptions& o) { o.threads = int(countOf(v)); }});
	t.push_back({"NewLayer",
				 "",
				 "",
				 ParameterKind::Switch,
				 "Put the result into a new layer",
				 "Off: the result takes the place of the layer's mesh. MeshLab has no undo, so "
				 "switch this on to keep the original.",
				 0,
				 1,
				 {},
				 [](const MeshFacts&) { return ParameterValue(false); },
				 nullptr});
	return t;
}

} // namespace

const std::vector<Parameter>& remeshParameters()
{
	static const std::vector<Parameter> table = makeTable();
	return table;
}

const Parameter* findParameter(const std::string& key)
{
	for (const Parameter& p : remeshParameters()) {
		if (key == p.key) return &p;
	}
	return nullptr;
}

RemeshOptions ParameterSet::unset()
{
	RemeshOptions o;
	o.targetVertexNum = 0;
	o.targetPercent   = 0;
	o.targetEdgeLen   = 0;
	return o;
}

void ParameterSet::set(const Parameter& parameter, const ParameterValue& value)
{
	if (parameter.store == nullptr) {
		newLayer_ = switchOf(value);
		return;
	}
	parameter.store(value, raw_);
}

RemeshOptions ParameterSet::options() const
{
	RemeshOptions o = raw_;
	if (o.targetEdgeLen != 0) {
		o.targetMode = TargetMode::EdgeLength;
	}
	else if (o.targetPercent != 0) {
		o.targetMode = TargetMode::Percent;
	}
	else if (o.targetVertexNum != 0) {
		o.targetMode = TargetMode::VertexNum;
	}
	else {
		o.targetMode    = TargetMode::Percent;
		o.targetPercent = RemeshOptions().targetPercent;
	}
	return o;
}

std::vector<std::string> ParameterSet::complaints() const
{
	std::vector<std::string> sentences = validate(options());
	if (raw_.targetEdgeLen != 0 && raw_.targetPercent != 0) {
		sentences.push_back("Give either a percentage or an edge length, not both.");
	}
	return sentences;
}

} // namespace gpr
