// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_BORDER_EDGE_SAMPLING_H
#define VCG_EXTRAS_CORE_SAMPLING_BORDER_EDGE_SAMPLING_H

#include "front_sampling.h"
#include "fused_mesh.h"

#include <vcg_extras/core/features/boundary_curves.h>

#include <cstdint>

namespace gpr {

/// What the border-edge sampling goes by.
struct BorderEdgeOptions {
	float               radius     = 0;       ///< r, working units
	std::uint32_t       seed       = 1;       ///< of the start vertices and the random choices
	std::int64_t        maxSamples = 1 << 30; ///< then it ends, and Sampling::capped is set
	const Buffer<char>* region = nullptr; ///< per vertex of the surface: sampled first; null: none
};

/// The samples, and the mesh they were fused into while they were placed.
struct BorderEdgeSampling {
	Sampling
		sampling; ///< surface points and distances in terms of the surface, which is not changed
	FusedMesh fused;
};

/// Eq. (3): where the disk of radius r round a sample ends on an edge whose ends lie at distances
/// d1 and d2 from it, by laying sample and edge into the plane. The larger of the two solutions, as
/// a share of the edge from its first end; negative where the disk does not reach the edge or ends
/// beyond it.
double borderCrossing(double d1, double d2, double edge, double r);

/// Stage::Sampling as the paper writes it (§3, steps 2–8; eq. (2), (3)): from a random start
/// vertex, disk by disk, each new sample on a border edge drawn at random from the cache C, fused
/// into the mesh by an edge split there and then.
///
/// Differs from the paper:
/// - It says nothing of open borders: their samples (see sampleBoundary) come first and are fused
///   before all others, so that the border keeps its shape.
/// - Nor of several components: when C is empty, a random vertex of one not yet reached starts
/// anew.
/// - A point of the border edge that lies in the disk of a further sample near by moves on along
/// the
///   edge to where the border of the union of disks, not of the one disk, crosses it.
/// - Within a thousandth of an edge of its end, that end becomes the sample, so that no needle
///   arises.
///
/// A region is sampled first, as §3.1.1 has it: start vertices in it, and border edges with both
/// ends in it, until none is left; then the rest.
///
/// Where the surface has sizes (see sizing.h), every way is longer by 1 over the mean size of the
/// ends of its edges: eq. (4), with the largest disk for unit.
///
/// Distances are propagated by unfolding triangles everywhere (see DiskFlood), not by chords where
/// all is flat.
/// Serial, so that it is the same for any number of threads. Cost: each vertex is visited about
/// four times; memory of a second mesh.
BorderEdgeSampling sampleBorderEdges(const Surface& surface, const BoundaryCurves& boundary,
									 const BorderEdgeOptions& options, Workers& workers);

} // namespace gpr

#endif
