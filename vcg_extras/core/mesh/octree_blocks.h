// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_OCTREE_BLOCKS_H
#define VCG_EXTRAS_CORE_MESH_OCTREE_BLOCKS_H

#include "connect.h"

#include <vcg_extras/core/base/workers.h>

#include <array>
#include <vector>

namespace gpr {

/// The vertices of an octree cell.
struct Block {
	int begin;
	int end;
};

/// The surface cut into octree cells. Two cells of the same colour are at least a cell's width
/// apart. So work in all cells of a colour can run at once without locks, if the work reaches less
/// than half a cell's width beyond its cell. The result depends only on the order of colours.
struct OctreeBlocks {
	std::vector<Block>              blocks;   ///< in vertex order
	std::array<std::vector<int>, 8> byColour; ///< by the parity of the cell's coordinates: block
											  ///< indices, largest block first
	float cellSize = 0;
};

/// Cuts at the deepest level with cells at least minCellSize wide (working units).
OctreeBlocks cutIntoBlocks(const Surface& surface, float minCellSize, Workers& workers);

} // namespace gpr

#endif
