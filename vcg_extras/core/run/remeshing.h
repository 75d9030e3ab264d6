// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_REMESHING_H
#define VCG_EXTRAS_CORE_RUN_REMESHING_H

#include "input_stages.h"

#include <vcg_extras/core/base/stage_clock.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/progress.h>
#include <vcg_extras/core/results.h>

#include <vector>

namespace gpr {

/// A call of the engine.
struct Call {
	const MeshView&         input;
	const RemeshOptions&    options;
	const ProgressCallback& progress;
	const StopRequest*      stop  = nullptr;
	InputCache*             cache = nullptr; ///< null: of a single run
};

// The pipelines. Each runs through the steps of a Plan (plan.h), and throws Failure where there is
// no result; the report and the notes of `out` tell how far it came.

/// The whole way from the input to the result.
void remeshInput(const Call& call, RemeshResult& out);
/// As far as the samples.
void sampleInput(const Call& call, SamplingResult& out);
/// From given points to a mesh of them.
void meshGivenSamples(const Call& call, const std::vector<Vec3d>& points, RemeshResult& out);
/// The features alone.
void detectOnly(const Call& call, FeatureResult& out);
/// Fills the cache of the call with what runs with these options have in common.
void prepareInput(const Call& call, RemeshResult& out);

} // namespace gpr

#endif
