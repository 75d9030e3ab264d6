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

/// The smallest distance of samples is (1 - spacingSlack) r; with 0, rounding would reject good
/// places.
constexpr float spacingSlack = 0.05f;

/// A geodesic Poisson-disk sampling, and its Voronoi cells as sets of working-surface vertices.
struct Sampling {
	float                         radius = 0;
	std::vector<Sample>           samples; ///< samples of the border first, in the same order
	int                           boundarySampleNum = 0;
	Buffer<NearestField::Nearest> nearest;        ///< per surface vertex: its sample and distance
	bool                          capped = false; ///< a block had no room left
};

/// Stage::Sampling: front sampling (paper §3, steps 2–8) with disk-intersection placement.
///
/// Differs from the paper: the next sample lies where the circles of radius r round two
/// neighbouring samples intersect (suggested in §5), which packs tighter than a random point of the
/// front. The intersection touched most closely by a third disk comes first. When no intersection
/// is left, the paper's border edges are used (eq. (2), (3)), then any vertex beyond r, so that
/// every component is reached. The mesh is not split: a sample is a point in a face.
///
/// A region (per vertex of the surface, or empty) is sampled first, as in §3.1.1: on edges and in
/// faces with all corners inside. So a region in the shape of a line is sampled along the line.
///
/// Works block by block (see OctreeBlocks); `seed` chooses the first free start of each block.
/// Cost: each vertex is visited 3.4 to 4 times.
Sampling sampleFront(const Surface& surface, const BoundaryCurves& boundary,
					 const OctreeBlocks& partition, float radius, std::uint32_t seed,
					 Workers& workers, const Buffer<char>& region = Buffer<char>());

/// The first of some samples that is nearer to a new sample than nearLimit times the mean of both
/// sizes, or -1. sameSideOnly: only samples that face the same way count, because through space the
/// other side of a thin sheet is near too. This is for a vertex that must get a sample.
template <class Samples>
int findTooNear(const std::vector<int>& some, const Samples& samples, const Sample& made,
				float nearLimit, bool sameSideOnly)
{
	constexpr float sameSideCosine = 0.8f; // 37°, as far as flat ground bends (sectors.h)
	for (int t : some) {
		const float limit = nearLimit * (0.5f * (made.size + samples[t].size));
		const Vec3f way   = made.point.position - samples[t].point.position;
		if (squaredLength(way) >= limit * limit) continue;
		if (!sameSideOnly || dot(made.normal, samples[t].normal) >= sameSideCosine) return t;
	}
	return -1;
}

/// The last step of a sampling. Assigns each vertex of a curve to the nearest sample along its
/// curve, and each cone apex to its own sample, with distance 0, whatever the interior chose. So no
/// vertex of a curve can become the vertex of an interior sample.
void labelBorder(const BoundaryCurves& boundary, Sampling& sampling);

} // namespace gpr

#endif
