// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "octree_blocks.h"

#include <vcg_extras/core/base/sort_unique.h>

#include <algorithm>

namespace gpr {

namespace {

int levelFor(const MortonGrid& grid, float minCellSize)
{
	int level = 0;
	while (level < grid.level && grid.cellSize(level + 1) >= minCellSize)
		++level;
	return level;
}

} // namespace

OctreeBlocks cutIntoBlocks(const Surface& surface, float minCellSize, Workers& workers)
{
	const HalfEdgeMesh& m     = surface.mesh;
	const MortonGrid&   grid  = surface.grid;
	const int           level = levelFor(grid, minCellSize);

	const auto             cellOf = [&](int v) { return grid.cell(m.position[v], level); };
	const std::vector<int> begins =
		workers.collect<int>(m.vertexNum, [&](std::size_t from, std::size_t to, auto& out) {
			const int end = int(to);
			for (int v = int(from); v < end;) {
				const auto isBeyond = [&](int i) { return cellOf(v + i) != cellOf(v); };
				if (v == 0 || isBeyond(-1)) out.push_back(v);
				v += firstOf(end - v, isBeyond);
			}
		});

	OctreeBlocks partition;
	partition.cellSize = grid.cellSize(level);
	for (std::size_t b = 0; b < begins.size(); ++b) {
		const int end = b + 1 < begins.size() ? begins[b + 1] : m.vertexNum;
		// The lowest bit of each coordinate is its parity.
		const int colour = int(grid.cell(m.position[begins[b]], level) & 7);
		partition.byColour[colour].push_back(int(b));
		partition.blocks.push_back({begins[b], end});
	}
	const auto sizeOf = [&](int b) { return partition.blocks[b].end - partition.blocks[b].begin; };
	for (std::vector<int>& ids : partition.byColour) {
		std::stable_sort(ids.begin(), ids.end(),
						 [&](int a, int b) { return sizeOf(a) > sizeOf(b); });
	}
	return partition;
}

} // namespace gpr
