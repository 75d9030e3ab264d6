// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// From the surface to the first mesh.
#include "bench_case.h"

#include <vcg_extras/core/retriangulation/hole_retriangulation.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/run/sample_stages.h>
#include <vcg_extras/core/run/surface_stages.h>
#include <vcg_extras/core/sampling/border_edge_sampling.h>
#include <vcg_extras/core/sampling/fused_mesh.h>

namespace gpr::bench {

namespace {

void cutBlocks(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products& made    = run.sampled();
	RunContext      context = run.contextFor(workers);
	timeEach(state, [&] {
		return cutForSampling(context, run.decisions(), made.samples.radius, made.surface);
	});
}

void boundaryCurves(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products& made    = run.sampled();
	RunContext      context = run.contextFor(workers);
	timeEach(state,
			 [&] { return sampleCurves(context, run.decisions(), made.samples.radius, made); });
}

void frontSampling(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products& p = run.sampled();
	const Samples&  s = p.samples;
	timeEach(state, [&] {
		return sampleFront(p.surface, s.curves, s.partition, s.radius, run.options().seed, workers);
	});
}

void labelCollapse(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products& p = run.sampled();
	const Samples&  s = p.samples;
	timeEach(state, [&] {
		return removeVertices(p.surface, s.sampling, s.curves, p.surface.figures, workers);
	});
}

// ---- the paper's own way

void borderEdgeSampling(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products&   p = run.sampled();
	const Samples&    s = p.samples;
	BorderEdgeOptions options;
	options.radius = s.radius;
	timeEach(state, [&] { return sampleBorderEdges(p.surface, s.curves, options, workers); });
}

void fuse(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products& p = run.sampled();
	const Samples&  s = p.samples;
	timeEach(state, [&] { return fuseSamples(p.surface, s.sampling, s.curves, workers); });
}

void vertexRemoval(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products& p = run.sampled();
	const Samples&  s = p.samples;
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
