// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "octree_blocks.h"

#include <algorithm>
#include <cstdint>

namespace gpr {

namespace {

int levelFor(const MortonGrid& grid, float minCellSize)
{
	int level = 0;
	while (level < grid.level && grid.cellSize(level + 1) >= minCellSize)
		++level;
	return level;
}

/// The end of v's cell, at most `end`. Vertices are in the order of cells: doubles the steps, then
/// bisects the last step, and so visits few vertices.
template <class CellOf>
int endOfCell(const CellOf& cellOf, int v, int end)
{
	const std::uint64_t cell = cellOf(v);
	int                 step = 1;
	while (step < end - v && cellOf(v + step) == cell)
		step *= 2;
	int inside = v + step / 2, outside = std::min(v + step, end);
	while (outside - inside > 1) {
		const int middle                            = inside + (outside - inside) / 2;
		(cellOf(middle) == cell ? inside : outside) = middle;
	}
	return outside;
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
			for (int v = int(from); v < end; v = endOfCell(cellOf, v, end)) {
				if (v == 0 || cellOf(v) != cellOf(v - 1)) out.push_back(v);
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
