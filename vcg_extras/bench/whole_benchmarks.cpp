// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// From mesh in memory to mesh in memory.
#include "bench_case.h"

#include <vcg_extras/core/remesh.h>

#include <stdexcept>

namespace gpr::bench {

namespace {

StageBenchmark wholeRun(Preset preset)
{
	return [preset](benchmark::State& state, StagedRun& run, Workers& workers) {
		RemeshOptions options = run.options();
		options.threads       = workers.threadNum();
		options.preset        = preset;
		timeEach(state, [&] {
			RemeshResult result = remesh(run.input(), options);
			if (result.status != Status::Ok) throw std::runtime_error(result.message);
			return result;
		});
	};
}

} // namespace

void addWholeBenchmarks(const BenchCase& on)
{
	addBenchmark("whole_default", on, wholeRun(Preset::Default));
	addBenchmark("whole_fast", on, wholeRun(Preset::Fast));
	if (!on.graded) addBenchmark("whole_paper", on, wholeRun(Preset::Paper));
}

} // namespace gpr::bench
