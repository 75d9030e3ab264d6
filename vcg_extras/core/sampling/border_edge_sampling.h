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
	std::int64_t        maxSamples = 1 << 30; ///< more set Sampling::capped
	const Buffer<char>* region = nullptr; ///< per vertex of the surface: sampled first; null: none
};

/// The samples, and the mesh into which they were fused while they were placed.
struct BorderEdgeSampling {
	Sampling
		sampling; ///< surface points and distances in terms of the surface, which is not changed
	FusedMesh fused;
};

/// Eq. (3): the place at which the disk of radius r round a sample ends on an edge. The ends of the
/// edge lie at distances d1 and d2 from the sample; sample and edge are laid into the plane.
/// Returns the larger of the two solutions, as a share of the edge from its first end; negative if
/// the disk does not reach the edge or ends beyond it.
double borderCrossing(double d1, double d2, double edge, double r);

/// Stage::Sampling as printed in the paper (§3, steps 2–8; eq. (2), (3)). Starts at a random vertex
/// and adds disk by disk: each new sample lies on a border edge drawn at random from the cache C,
/// and an edge split fuses the sample into the mesh at once.
///
/// Differs from the paper:
/// - The paper has no open borders. Here samples on the border (see sampleBoundary) come first and
///   are fused before all others, so that the border keeps its shape.
/// - The paper has one component. Here an empty C starts anew at a random vertex of a component not
///   yet reached.
/// - A point on a border edge may lie in the disk of another sample close by. Then the point moves
///   along the edge to the border of the union of disks.
/// - A place within a thousandth of the edge from its end becomes the end, so that no needle
/// arises.
///
/// A region is sampled first, as in §3.1.1: start vertices inside, and border edges with both ends
/// inside, until none is left; then the rest of the surface.
///
/// If the surface has sizes (see sizing.h), every edge is longer by 1 over the mean size at its
/// ends: eq. (4), with the largest disk as unit.
///
/// Distances are propagated by unfolding triangles everywhere (see DiskFlood), never by chords on
/// flat ground. Serial, so that the result is the same for any number of threads. Cost: about four
/// visits of each vertex; memory of a second mesh.
BorderEdgeSampling sampleBorderEdges(const Surface& surface, const BoundaryCurves& boundary,
									 const BorderEdgeOptions& options, Workers& workers);

} // namespace gpr

#endif
