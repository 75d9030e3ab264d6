// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_BENCH_CASE_H
#define VCG_EXTRAS_BENCH_BENCH_CASE_H

#include "staged_run.h"

#include <vcg_extras/io/base/stopwatch.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <benchmark/benchmark.h>
#include <functional>
#include <string>
#include <vector>

namespace gpr::bench {

/// A mesh to measure with, made or read when it is first needed.
struct BenchMesh {
	std::string                     name;
	std::function<app::InputMesh()> make;
};

/// Those made in code, then the files that GPR_BENCH_MESHES names, with colons between them.
std::vector<BenchMesh> benchMeshes();

/// What a benchmark runs on.
struct BenchCase {
	BenchMesh mesh;
	bool      graded  = false; ///< sizes by the error instead of even ones
	int       threads = 1;
};

/// Measures one stage: what it begins with is in the run, the threads it may use in the workers.
using StageBenchmark = std::function<void(benchmark::State&, StagedRun&, Workers&)>;

/// Registers a benchmark by the name STAGE/MESH/DENSITY/threads:N. It tells milliseconds of wall
/// time and faces of the input a second.
void addBenchmark(const std::string& stage, const BenchCase& on, const StageBenchmark& stageBody);

/// Times work(subject) for a fresh subject = make() in each round; making it, and taking it and the
/// outcome apart, is not timed.
template <class Make, class Work>
void timeEach(benchmark::State& state, const Make& make, const Work& work)
{
	for (auto _ : state) {
		auto                 subject = make();
		const app::Stopwatch clock;
		const auto           outcome = work(subject);
		state.SetIterationTime(clock.seconds());
		(void) outcome;
	}
}

/// The same for what needs nothing fresh.
template <class Work>
void timeEach(benchmark::State& state, const Work& work)
{
	timeEach(
		state, [] { return 0; }, [&](int) { return work(); });
}

// ---- the groups, in the order of a run

void addInputBenchmarks(const BenchCase& on);       ///< reading, writing, up to the surface
void addSamplingBenchmarks(const BenchCase& on);    ///< from the surface to the first mesh
void addImprovementBenchmarks(const BenchCase& on); ///< from there to the audit
void addWholeBenchmarks(const BenchCase& on);       ///< all of it, by presets

} // namespace gpr::bench

#endif
