// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_SAMPLE_RANGES_H
#define VCG_EXTRAS_CORE_SAMPLING_SAMPLE_RANGES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/octree_blocks.h>

#include <vector>

namespace gpr {

/// The range of sample numbers of a block while blocks are sampled in parallel.
struct BlockRange {
	int firstSample = 0; ///< [firstSample, firstSample + room) belong to the block
	int room        = 0;
	int used        = 0;
};

/// Makes a range for each block, from firstSample on, with room for all samples that disks of
/// radius r leave on the faces of the block, and a few more. Cost: a parallel pass over the faces.
std::vector<BlockRange> makeRanges(const Surface& surface, const OctreeBlocks& partition,
								   float radius, int firstSample, Workers& workers);

} // namespace gpr

#endif
