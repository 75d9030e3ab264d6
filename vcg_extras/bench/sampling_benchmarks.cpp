// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// From the surface to the first mesh.
#include "bench_case.h"

#include <vcg_extras/core/retriangulation/hole_retriangulation.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/run/feature_lines.h>
#include <vcg_extras/core/sampling/border_edge_sampling.h>
#include <vcg_extras/core/sampling/fuse_samples.h>

namespace gpr::bench {

namespace {

void cutBlocks(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Prepared& p       = run.prepared();
	RunContext      context = run.contextFor(workers);
	timeEach(state, [&] { return cutForSampling(context, p); });
}

void boundaryCurves(benchmark::State& state, StagedRun& run, Workers&)
{
	const Prepared& p = run.prepared();
	timeEach(state, [&] { return sampleCurves(p, p.radius, BoundaryMode::Resample); });
}

void frontSampling(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Prepared&     p = run.prepared();
	const SampledState& s = run.sampled();
	timeEach(state, [&] {
		return sampleFront(p.surface, s.curves, s.partition, s.sampling.radius, run.options().seed,
						   workers);
	});
}

void labelCollapse(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Prepared&     p = run.prepared();
	const SampledState& s = run.sampled();
	timeEach(state, [&] {
		return removeVertices(p.surface, s.sampling, s.curves, run.inputFigures(), workers);
	});
}

// ---- the paper's own way

void borderEdgeSampling(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Prepared&     p = run.prepared();
	const SampledState& s = run.sampled();
	BorderEdgeOptions   options;
	options.radius = p.radius;
	timeEach(state, [&] { return sampleBorderEdges(p.surface, s.curves, options, workers); });
}

void fuse(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Prepared&     p = run.prepared();
	const SampledState& s = run.sampled();
	timeEach(state, [&] { return fuseSamples(p.surface, s.sampling, s.curves, workers); });
}

void vertexRemoval(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Prepared&     p = run.prepared();
	const SampledState& s = run.sampled();
	timeEach(
		state, [&] { return fuseSamples(p.surface, s.sampling, s.curves, workers); },
		[&](FusedMesh& fused) {
			return removeOriginalVertices(std::move(fused), p.surface, s.sampling, s.curves,
										  s.partition, workers);
		});
}

} // namespace

void addSamplingBenchmarks(const BenchCase& on)
{
	addBenchmark("blocks", on, cutBlocks);
	addBenchmark("boundary_curves", on, boundaryCurves);
	addBenchmark("front_sampling", on, frontSampling);
	addBenchmark("label_collapse", on, labelCollapse);
	addBenchmark("paper_border_edge_sampling", on, borderEdgeSampling);
	addBenchmark("paper_fuse", on, fuse);
	addBenchmark("paper_vertex_removal", on, vertexRemoval);
}

} // namespace gpr::bench
