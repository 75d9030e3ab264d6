// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_FUSE_SAMPLES_H
#define VCG_EXTRAS_CORE_SAMPLING_FUSE_SAMPLES_H

#include "front_sampling.h"
#include "fused_mesh.h"

#include <vcg_extras/core/features/boundary_curves.h>

namespace gpr {

/// Fuses samples of any placement into the surface (paper §3, step 6): each sample becomes the
/// vertex at its place, or splits its edge in two or its face in three. A sample is at a vertex or
/// an edge within a thousandth of the face, the limit of rounding; the vertex then moves to the
/// sample. If `boundary` has samples, these and no others become vertices of the border. A sample
/// that falls on an earlier sample, or on the border without belonging there, gets no vertex: its
/// sampleVertex is -1.
///
/// Differs from the paper: its samples lie on edges and need edge splits only. Cost: a copy of the
/// surface, and a few faces a sample.
FusedMesh fuseSamples(const Surface& surface, const Sampling& sampling,
					  const BoundaryCurves& boundary, Workers& workers);

} // namespace gpr

#endif
