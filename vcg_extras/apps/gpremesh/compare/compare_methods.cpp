// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_methods.h"

#include "baseline_remeshers.h"

#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/report/remesh_outcome.h>

#include <algorithm>

namespace gpr::app {

namespace {

/// The data shared by all methods.
struct Comparison {
	const InputMesh& input;
	CompareRecord    record;
	std::int64_t     faceNum = 0; ///< of the default path's result
	double           edgeLen = 0; ///< mean edge of the same result
};

struct Method {
	const char* key;
	const char* name;
	const char* column;
	BaselineResult (*run)(Comparison&);
};

BaselineResult runEngine(const Comparison& c, const RemeshOptions& options, RemeshResult& result)
{
	const double processorBefore = processorSeconds();
	result = remesh(c.input.view(), options, [](double, const char*) { return !stopRequested(); });
	BaselineResult out;
	out.seconds          = result.report.remeshSeconds;
	out.processorSeconds = processorSeconds() - processorBefore;
	if (result.status != Status::Ok) out.failure = sentenceOf(result);
	out.mesh = std::move(result.mesh);
	return out;
}

BaselineResult runDefault(Comparison& c)
{
	RemeshResult   result;
	BaselineResult out = runEngine(c, c.record.line.options, result);
	requireDone(result);
	c.faceNum             = std::int64_t(out.mesh.faceNum());
	c.edgeLen             = result.report.quality.meanEdgeLen;
	c.record.cleanedInput = result.report.cleanedInput;
	c.record.threads      = result.report.threads;
	return out;
}

BaselineResult runPaper(Comparison& c)
{
	RemeshOptions options = c.record.line.options;
	options.preset        = Preset::Paper;
	RemeshResult result;
	return runEngine(c, options, result);
}

BaselineResult runQuadric(Comparison& c)
{
	return collapseQuadricEdges(c.input.view(), c.faceNum, stopRequested);
}

BaselineResult runIsotropic(Comparison& c)
{
	return remeshIsotropically(c.input.view(), c.edgeLen);
}

std::vector<Method> chosenMethods(const CommandLine& line)
{
	std::vector<Method> methods = {{"default", "gpremesh", "gpremesh", runDefault}};
	if (!isPaper(line.options))
		methods.push_back({"paper", "gpremesh, preset paper", "paper", runPaper});
	methods.push_back({"quadricEdgeCollapse", "Quadric Edge Collapse", "QEC", runQuadric});
	if (line.isotropic) {
		methods.push_back({"isotropicRemeshing", "isotropic remeshing", "isotropic", runIsotropic});
	}
	return methods;
}

/// Runs a method once more and keeps the mesh of its first run.
void runOnce(const Method& method, Comparison& comparison, MethodRecord& record)
{
	if (!record.failure.empty()) return;
	BaselineResult out = method.run(comparison);
	record.failure     = out.failure;
	record.seconds.push_back(out.seconds);
	record.processorSeconds.push_back(out.processorSeconds);
	if (record.mesh.faceNum() == 0) record.mesh = std::move(out.mesh);
}

std::int64_t nonManifoldEdgeNum(const MeshView& mesh, Workers& workers)
{
	const auto isUsable = [&](const EdgeSide& side) {
		const auto t = mesh.triangle(std::size_t(side.halfEdge / 3));
		return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
	};
	const Buffer<EdgeSide> sides = sortedSides(mesh, workers);
	std::int64_t           num   = 0;
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		num += std::count_if(sides.begin() + begin, sides.begin() + end, isUsable) > 2;
	});
	return num;
}

MeshRecord recordOf(const MeshView& mesh, Workers& workers)
{
	return {measureMesh(mesh), measureQuality(mesh, workers), nonManifoldEdgeNum(mesh, workers)};
}

/// A method keeps the topology if the result has the topology of the input or, for an input that is
/// not manifold, of the input as cut by the engine.
bool keepsTopology(const MeshRecord& result, const CompareRecord& all)
{
	return result.nonManifoldEdges <= all.input.nonManifoldEdges &&
		   (result.figures.hasTopologyOf(all.input.figures) ||
			result.figures.hasTopologyOf(all.cleanedInput));
}

void measureMethod(const MeshView& input, const MeasuredSurface& target, const CompareRecord& all,
				   MethodRecord& method, Workers& workers)
{
	if (!method.failure.empty()) return;
	const MeshView result = method.mesh.view();
	method.record         = recordOf(result, workers);
	method.topologyKept   = keepsTopology(method.record, all);
	method.distance = compareSurfaces(input, target, result, all.input.figures.diagonal, workers);
}

} // namespace

double median(std::vector<double> values)
{
	if (values.empty()) return 0;
	std::sort(values.begin(), values.end());
	const std::size_t half = values.size() / 2;
	return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

CompareRecord compareMethods(const InputMesh& input, const CommandLine& line,
							 const CompareProgress& progress)
{
	Comparison                comparison = {input, {}};
	const std::vector<Method> methods    = chosenMethods(line);
	CompareRecord&            record     = comparison.record;
	record.line                          = line;
	const double stepNum                 = double(methods.size()) * (line.runNum + 1) + 1;
	double       done                    = 0;
	for (const Method& m : methods) {
		record.methods.emplace_back();
		record.methods.back().key    = m.key;
		record.methods.back().name   = m.name;
		record.methods.back().column = m.column;
	}
	for (int run = 0; run < line.runNum; ++run) {
		for (std::size_t i = 0; i < methods.size(); ++i) {
			progress(done++ / stepNum, methods[i].name);
			runOnce(methods[i], comparison, record.methods[i]);
		}
	}
	progress(done++ / stepNum, "measuring the input");
	Workers workers(line.options.threads, nullptr);
	record.inputDouble = input.doublePrecision;
	record.notes       = input.notes;
	record.input       = recordOf(input.view(), workers);
	const MeasuredSurface target(input.view(), workers);
	for (MethodRecord& m : record.methods) {
		progress(done++ / stepNum, "measuring " + m.name);
		measureMethod(input.view(), target, record, m, workers);
	}
	progress(1, "done");
	return record;
}

} // namespace gpr::app
