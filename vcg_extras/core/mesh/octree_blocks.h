// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_OCTREE_BLOCKS_H
#define VCG_EXTRAS_CORE_MESH_OCTREE_BLOCKS_H

#include "connect.h"

#include <vcg_extras/core/base/workers.h>

#include <array>
#include <vector>

namespace gpr {

/// The vertices of one octree cell.
struct Block {
	int begin;
	int end;
	int colour; ///< parity of the cell's coordinates, 0 to 7
};

/// The surface cut into octree cells. Cells of one colour have at least a cell's width between
/// them: work that begins in a cell and reaches less than half of that beyond it can be done in all
/// cells of a colour at once, without locks, and the outcome depends only on the order of the
/// colours.
struct OctreeBlocks {
	std::vector<Block>              blocks;   ///< in vertex order
	std::array<std::vector<int>, 8> byColour; ///< block indices, largest block first
	float                           cellSize = 0;
};

/// The deepest cells that are at least minCellSize wide (working units).
OctreeBlocks cutIntoBlocks(const Surface& surface, float minCellSize, Workers& workers);

} // namespace gpr

#endif
