// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_SAMPLE_RANGES_H
#define VCG_EXTRAS_CORE_SAMPLING_SAMPLE_RANGES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/octree_blocks.h>

#include <vector>

namespace gpr {

/// The numbers that the samples of a block may take while blocks are sampled side by side.
struct BlockRange {
	int firstSample = 0; ///< [firstSample, firstSample + room) belong to the block
	int room        = 0;
	int used        = 0;
};

/// A range for each block, the first from firstSample on, with room for as many samples as disks of
/// radius r leave on its faces and some more. Cost: a parallel pass over the faces.
std::vector<BlockRange> makeRanges(const Surface& surface, const OctreeBlocks& partition,
								   float radius, int firstSample, Workers& workers);

} // namespace gpr

#endif
