// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_GIVEN_SAMPLES_H
#define VCG_EXTRAS_CORE_RUN_GIVEN_SAMPLES_H

#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/results.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// Samples of any origin in the place of our own.
struct GivenSamples {
	Sampling          sampling;
	std::vector<char> isMoved; ///< per sample: it was off the surface
};

/// Puts the points on the surface, each to the nearest place.
GivenSamples takeOverSamples(RunContext& run, const Prepared& p, const std::vector<Vec3d>& points);

/// Tells which vertex of the result is which sample. A sample that lay on the surface, up to
/// rounding, keeps its very coordinates.
void nameSamples(const std::vector<Vec3d>& points, const std::vector<char>& isMoved,
				 const ResultMesh& result, RemeshResult& out);

} // namespace gpr

#endif
