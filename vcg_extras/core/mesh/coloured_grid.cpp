// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "coloured_grid.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace gpr {

namespace {

/// In cell widths. Half a width would touch the next cell of the same colour.
constexpr float reachBeyondSide = 0.48f;

/// Coordinates of a cell, 20 bits each.
struct CellNumber {
	std::uint64_t x, y, z;

	std::uint64_t key() const { return x << 40 | y << 20 | z; }
	int           colour() const { return int((x & 1) << 2 | (y & 1) << 1 | (z & 1)); }
};

/// Coordinates are above this: the working frame is the unit cube about the origin, or smaller.
constexpr float lowest = -2;

CellNumber cellOf(const Vec3f& p, float width)
{
	const auto number = [&](float c) {
		return std::uint64_t(std::clamp((c - lowest) / width, 0.0f, 1048575.0f));
	};
	return {number(p.x), number(p.y), number(p.z)};
}

GridCell makeCell(const CellNumber& n, float width)
{
	const auto middle = [&](std::uint64_t i) { return lowest + (float(i) + 0.5f) * width; };
	GridCell   cell;
	cell.centre = {middle(n.x), middle(n.y), middle(n.z)};
	cell.reach  = (0.5f + reachBeyondSide) * width;
	return cell;
}

} // namespace

ColouredGrid cutIntoGridCells(const HalfEdgeMesh& m, const std::vector<int>& vertices, float width)
{
	std::vector<std::pair<std::uint64_t, int>> keyed; // the key of its cell and the vertex
	keyed.reserve(vertices.size());
	for (int v : vertices)
		keyed.emplace_back(cellOf(m.position[v], width).key(), v);
	std::sort(keyed.begin(), keyed.end());

	ColouredGrid cells;
	cells.vertices.reserve(keyed.size());
	std::uint64_t lastKey = 0;
	for (const auto& [key, v] : keyed) {
		const int              place  = int(cells.vertices.size());
		const CellNumber       number = cellOf(m.position[v], width);
		std::vector<GridCell>& own    = cells.byColour[number.colour()];
		if (place == 0 || key != lastKey) {
			own.push_back(makeCell(number, width));
			own.back().begin = place;
		}
		own.back().end = place + 1;
		lastKey        = key;
		cells.vertices.push_back(v);
	}
	return cells;
}

} // namespace gpr
