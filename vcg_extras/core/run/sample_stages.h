// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_SAMPLE_STAGES_H
#define VCG_EXTRAS_CORE_RUN_SAMPLE_STAGES_H

#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/octree_blocks.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/sampling/fused_mesh.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Samples of the surface, and what the retriangulation takes over from the sampling.
struct Sampled {
	OctreeBlocks   partition;
	BoundaryCurves curves;
	Sampling       sampling;
	FusedMesh      fused; ///< with the samples of the border-edge placement, else empty
};

/// A mesh under way and the curves that its vertices lie on.
struct Meshed {
	ResultMesh     result;
	BoundaryCurves curves;
};

OctreeBlocks cutForSampling(RunContext& run, const Prepared& p);

/// Samples of about the wanted number, placed in the way that the options choose.
Sampled sampleSurface(RunContext& run, const Prepared& p);

/// From samples to a mesh of them, in the way that the options choose.
Meshed retriangulateSamples(RunContext& run, const Prepared& p, Sampled sampled);

/// Both, and the first flips.
Meshed sampleAndRetriangulate(RunContext& run, const Prepared& p);

} // namespace gpr

#endif
