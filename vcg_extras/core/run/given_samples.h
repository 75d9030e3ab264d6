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
class GivenSamples : RunPart {
public:
	explicit GivenSamples(RunContext& run) : RunPart(run) {}

	Sampling takeOver(const Prepared& p, const std::vector<Vec3d>& points);
	/// A sample that lay on the surface, up to rounding, keeps its very coordinates.
	void nameSamples(const std::vector<Vec3d>& points, const ResultMesh& result, RemeshResult& out);

private:
	std::vector<char> sampleMoved_; ///< those that were off the surface
};

} // namespace gpr

#endif
