// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blocks.h"

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

BlockPartition cutIntoBlocks(const Surface& surface, float minCellSize, Workers& workers)
{
	const HalfEdgeMesh& m     = surface.mesh;
	const MortonGrid&   grid  = surface.grid;
	const int           level = levelFor(grid, minCellSize);

	const std::vector<int> begins =
		workers.collect<int>(m.vertexNum, [&](std::size_t from, std::size_t to, auto& out) {
			constexpr std::uint64_t none = ~std::uint64_t(0); // no cell has this number
			std::uint64_t before = from == 0 ? none : grid.cell(m.position[from - 1], level);
			for (std::size_t v = from; v < to; ++v) {
				const std::uint64_t here = grid.cell(m.position[v], level);
				if (here != before) out.push_back(int(v));
				before = here;
			}
		});

	BlockPartition partition;
	partition.cellSize = grid.cellSize(level);
	for (std::size_t b = 0; b < begins.size(); ++b) {
		const int end = b + 1 < begins.size() ? begins[b + 1] : m.vertexNum;
		// The lowest bit of each coordinate is its parity.
		const int colour = int(grid.cell(m.position[begins[b]], level) & 7);
		partition.byColour[colour].push_back(int(b));
		partition.blocks.push_back({begins[b], end, colour});
	}
	const auto sizeOf = [&](int b) { return partition.blocks[b].end - partition.blocks[b].begin; };
	for (std::vector<int>& ids : partition.byColour) {
		std::stable_sort(ids.begin(), ids.end(),
						 [&](int a, int b) { return sizeOf(a) > sizeOf(b); });
	}
	return partition;
}

} // namespace gpr
