// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// gpremesh_bench: measures every stage alone, and whole runs.
#include "bench_case.h"

namespace {

using namespace gpr::bench;

void addAll(const BenchCase& on)
{
	addInputBenchmarks(on);
	addSamplingBenchmarks(on);
	addImprovementBenchmarks(on);
	addWholeBenchmarks(on);
}

} // namespace

int main(int argc, char** argv)
{
	benchmark::Initialize(&argc, argv);
	if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
	for (const BenchMesh& mesh : benchMeshes())
		for (const bool graded : {false, true})
			for (const int threads : {1, 2})
				addAll({mesh, graded, threads});
	benchmark::RunSpecifiedBenchmarks();
	benchmark::Shutdown();
	return 0;
}
