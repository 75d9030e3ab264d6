// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_PARTIAL_RUNS_H
#define VCG_EXTRAS_CORE_RUN_PARTIAL_RUNS_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/results.h>

#include <vector>

namespace gpr {

// Pipelines with some stages of the whole way. Each throws Failure where there is no result.

void sampleInput(RunContext& run, SamplingResult& out);
void meshGivenSamples(RunContext& run, const std::vector<Vec3d>& points, RemeshResult& out);
void detectOnly(RunContext& run, FeatureResult& out);

} // namespace gpr

#endif
