// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// From the first mesh to the audit.
#include "bench_case.h"

#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/optimization/delaunay_flips.h>
#include <vcg_extras/core/optimization/exact_count.h>
#include <vcg_extras/core/optimization/face_repair.h>
#include <vcg_extras/core/optimization/relaxation.h>
#include <vcg_extras/core/optimization/valence_glide.h>
#include <vcg_extras/core/output/audit.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/run/result_stages.h>

namespace gpr::bench {

namespace {

/// Times a change of the result, each time on a fresh copy made outside of the time.
template <class Change>
void timeChange(benchmark::State& state, const ResultMesh& before, const Change& change)
{
	Workers one(1, nullptr);
	timeEach(
		state, [&] { return copyResult(before, one); },
		[&](ResultMesh& result) {
			change(result);
			return 0;
		});
}

void flips(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products&  made = run.sampled();
	const ResultMesh mesh = removeVertices(made.surface, made.samples.sampling, made.samples.curves,
										   made.surface.figures, workers);
	timeChange(state, mesh, [&](ResultMesh& result) { flipToDelaunay(result, workers); });
}

void invertedFacesRepair(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Surface&        surface  = run.sampled().surface;
	const BoundaryCurves& boundary = run.sampled().samples.curves;
	timeChange(state, run.improved().flipped, [&](ResultMesh& result) {
		repairInvertedFaces(surface, boundary, true, result, workers);
	});
}

void exactCount(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products&       p        = run.sampled();
	const BoundaryCurves& boundary = run.sampled().samples.curves;
	timeChange(state, run.improved().flipped, [&](ResultMesh& result) {
		reachExactCount(p.surface, boundary, run.decisions().countTarget(), result, workers);
	});
}

void relaxation(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Surface& surface = run.sampled().surface;
	timeChange(state, run.improved().counted,
			   [&](ResultMesh& result) { relaxOnce(surface, result, workers); });
}

void valenceGlide(benchmark::State& state, StagedRun& run, Workers& workers)
{
	timeChange(state, run.improved().counted,
			   [&](ResultMesh& result) { glideDislocations(result, workers); });
}

void conformal(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Surface&        surface  = run.sampled().surface;
	const BoundaryCurves& boundary = run.sampled().samples.curves;
	timeChange(state, run.improved().glided, [&](ResultMesh& result) {
		relaxConformally(surface, boundary, 2 * relaxationSteps, result, workers);
	});
}

void fit(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Surface&        surface  = run.sampled().surface;
	const BoundaryCurves& boundary = run.sampled().samples.curves;
	timeChange(state, run.improved().repaired, [&](ResultMesh& result) {
		fitToInput(surface, boundary, fitSettings(run.options(), false), result, workers);
	});
}

void poorFacesRepair(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Surface&        surface = run.sampled().surface;
	const BoundaryCurves& curves  = run.sampled().samples.curves;
	timeChange(state, run.improved().fitted, [&](ResultMesh& result) {
		PoorFaces wanted;
		raiseSmallAngles(surface, curves, wanted, result, workers);
		repairPoorFaces(surface, curves, wanted, result, workers);
	});
}

void auditResult(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Surface&    surface = run.sampled().surface;
	const ResultMesh& result  = run.improved().fitted;
	const MeshFigures input   = run.sampled().surface.figures;
	timeEach(state, [&] {
		const MeshFigures output = figuresOf(result.mesh, 1, workers);
		return audit(surface, result, input, output, 0, workers);
	});
}

} // namespace

void addImprovementBenchmarks(const BenchCase& on)
{
	addBenchmark("flips", on, flips);
	addBenchmark("inverted_faces", on, invertedFacesRepair);
	addBenchmark("exact_count", on, exactCount);
	addBenchmark("relaxation", on, relaxation);
	addBenchmark("valence_glide", on, valenceGlide);
	addBenchmark("conformal_relaxation", on, conformal);
	addBenchmark("fit", on, fit);
	addBenchmark("poor_faces", on, poorFacesRepair);
	addBenchmark("audit", on, auditResult);
}

} // namespace gpr::bench
