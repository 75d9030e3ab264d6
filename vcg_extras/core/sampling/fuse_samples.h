// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_FUSE_SAMPLES_H
#define VCG_EXTRAS_CORE_SAMPLING_FUSE_SAMPLES_H

#include "front_sampling.h"
#include "fused_mesh.h"

#include <vcg_extras/core/features/boundary_curves.h>

namespace gpr {

/// Makes samples of any placement vertices of the surface (paper §3, step 6): a sample becomes the
/// vertex it lies on, splits the edge it lies on, or else its face in three. On means: within a
/// thousandth of the face, which rounding could not tell apart; the vertex then takes the sample's
/// place. Where `boundary` has samples, those and no others become vertices of the border. A sample
/// that falls on an earlier one, or on the border though it is none of its samples, gets no vertex:
/// sampleVertex is -1 there.
///
/// Differs from the paper, whose samples lie on edges and need edge splits only.
/// Cost: a copy of the surface, and a few faces a sample.
FusedMesh fuseSamples(const Surface& surface, const Sampling& sampling,
					  const BoundaryCurves& boundary, Workers& workers);

} // namespace gpr

#endif
