// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_FRONT_SAMPLING_H
#define VCG_EXTRAS_CORE_SAMPLING_FRONT_SAMPLING_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/octree_blocks.h>
#include <vcg_extras/core/surface/disk_flood.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Smallest spacing of samples is (1 - spacingSlack) r; 0 would let rounding reject good places.
constexpr float spacingSlack = 0.05f;

/// A geodesic Poisson-disk sampling and the Voronoi cells it makes of the input's vertices.
struct Sampling {
	float                         radius = 0;
	std::vector<Sample>           samples; ///< those of the border first, in their order
	int                           boundarySampleNum = 0;
	Buffer<NearestField::Nearest> nearest; ///< per input vertex: its sample and how far
	std::int64_t fillNum = 0;     ///< samples placed by border edge or scan, not by intersection
	bool         capped  = false; ///< a block had room for no more samples
};

/// Stage::Sampling: front sampling (paper §3, steps 2–8) with disk-intersection placement.
///
/// Differs from the paper: the next sample is put where the circles of radius r round two
/// neighbouring samples intersect (the paper's own wish, §5), which packs tighter than a random
/// point of the front; the place touched most closely by a third disk comes first. Where no
/// intersection is left, the paper's border edges are used (eq. (2), (3)), then any vertex beyond
/// r, which reaches every component. The mesh is not split: a sample is a point in a face.
///
/// A region, if given (per vertex of the surface), is sampled first, as §3.1.1 has it: on edges and
/// in faces whose corners all belong to it. So a region that is a line is sampled along it.
///
/// Works block by block (see OctreeBlocks); each block's first free start is chosen by `seed`.
/// Cost: each vertex is visited 3.4 to 4 times.
Sampling sampleFront(const Surface& surface, const BoundaryCurves& boundary,
					 const OctreeBlocks& partition, float radius, std::uint32_t seed,
					 Workers& workers, const Buffer<char>& region = Buffer<char>());

/// The last step of a sampling: border vertices belong to the nearest sample along their curve, at
/// distance 0 whatever the interior chose: no interior sample is stood for by a border vertex.
void labelBorder(const BoundaryCurves& boundary, Sampling& sampling);

} // namespace gpr

#endif
