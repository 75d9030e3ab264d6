// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_BORDER_EDGE_SAMPLING_H
#define VCG_EXTRAS_CORE_SAMPLING_BORDER_EDGE_SAMPLING_H

#include "front_sampling.h"
#include "fused_mesh.h"

#include <vcg_extras/core/features/boundary_curves.h>

#include <cstdint>

namespace gpr {

/// Options of the border-edge sampling.
struct BorderEdgeOptions {
	float               radius     = 0;       ///< r, working units
	std::uint32_t       seed       = 1;       ///< of start vertices and random choices
	std::int64_t        maxSamples = 1 << 30; ///< the sampling ends here: Sampling::capped
	const Buffer<char>* region = nullptr; ///< per vertex of the surface: sampled first; null: none
};

/// The samples, and the mesh with the samples as vertices.
struct BorderEdgeSampling {
	Sampling
		sampling; ///< surface points, and the sample and distance of each vertex of the surface
	FusedMesh fused;
};

/// Eq. (3): the place at which the disk of radius r round a sample ends on an edge of length
/// `edge`. The ends of the edge lie at distances d1 and d2 from the sample, in one plane. Returns
/// the larger of the two solutions, as a share of the edge from its first end; negative if the disk
/// does not reach the edge or ends beyond it.
double borderCrossing(double d1, double d2, double edge, double r);

/// Stage::Sampling as printed in the paper (§3, steps 2–8; eq. (2), (3)). Starts at a random vertex
/// and adds disk by disk. A border edge leads from a vertex in a disk to a vertex in no disk. Each
/// new sample lies on a random border edge; an edge split makes the sample a vertex at once.
///
/// Differs from the paper:
/// - Samples of curves (see sampleBoundary) come first, so that the curves keep their shape.
/// - The paper has one component. Here, when no border edge is left, a random vertex in no disk is
///   the next sample.
/// - A point on a border edge may lie in the disk of another sample. Then the point moves along the
///   edge to the end of that disk.
/// - A point within a thousandth of the edge from its end becomes the end: no needle arises.
///
/// A region is sampled first, as in §3.1.1: start vertices inside, and border edges with both ends
/// inside, until none is left; then the rest of the surface.
///
/// If the surface has sizes (see sizing.h), the length of an edge is multiplied by the mean of
/// 1/size at its ends: eq. (4), with the largest disk as unit.
///
/// DiskFlood finds all distances by unfolding triangles, also on flat ground. Serial, so that the
/// result is the same for any number of threads. Cost: about four visits of each vertex; memory of
/// a second mesh.
BorderEdgeSampling sampleBorderEdges(const Surface& surface, const BoundaryCurves& boundary,
									 const BorderEdgeOptions& options, Workers& workers);

} // namespace gpr

#endif
