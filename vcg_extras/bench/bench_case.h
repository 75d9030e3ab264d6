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

/// A mesh for measurements, made or read at its first use.
struct BenchMesh {
	std::string                     name;
	std::function<app::InputMesh()> make;
};

/// The meshes made in code, then the files of GPR_BENCH_MESHES, separated by colons.
std::vector<BenchMesh> benchMeshes();

/// The subject of a benchmark.
struct BenchCase {
	BenchMesh mesh;
	bool      graded  = false; ///< sizes by the error, not even sizes
	int       threads = 1;
};

/// Measures a stage: the run has the stage's input, the workers have its threads.
using StageBenchmark = std::function<void(benchmark::State&, StagedRun&, Workers&)>;

/// Registers a benchmark by the name STAGE/MESH/DENSITY/threads:N. Reports milliseconds of wall
/// time and input faces per second.
void addBenchmark(const std::string& stage, const BenchCase& on, const StageBenchmark& stageBody);

/// Times work(subject) for a fresh subject = make() in each round; making the subject, and freeing
/// subject and outcome, is not timed.
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

/// Times work() without a fresh subject.
template <class Work>
void timeEach(benchmark::State& state, const Work& work)
{
	timeEach(
		state, [] { return 0; }, [&](int) { return work(); });
}

// ---- the groups, in the order of a run

void addInputBenchmarks(const BenchCase& on);       ///< reading, writing, up to the surface
void addSamplingBenchmarks(const BenchCase& on);    ///< from the surface to the first mesh
void addImprovementBenchmarks(const BenchCase& on); ///< from the first mesh to the audit
void addWholeBenchmarks(const BenchCase& on);       ///< whole runs, by presets

} // namespace gpr::bench

#endif
