// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "coloured_grid.h"

#include <algorithm>
#include <cstdint>

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

struct KeyedVertex {
	std::uint64_t key;
	int           vertex;

	bool operator<(const KeyedVertex& o) const
	{
		return key != o.key ? key < o.key : vertex < o.vertex;
	}
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
	std::vector<KeyedVertex> keyed;
	keyed.reserve(vertices.size());
	for (int v : vertices)
		keyed.push_back({cellOf(m.position[v], width).key(), v});
	std::sort(keyed.begin(), keyed.end());

	ColouredGrid cells;
	cells.vertices.reserve(keyed.size());
	for (std::size_t i = 0; i < keyed.size(); ++i) {
		const CellNumber       number = cellOf(m.position[keyed[i].vertex], width);
		std::vector<GridCell>& own    = cells.byColour[number.colour()];
		if (i == 0 || keyed[i].key != keyed[i - 1].key) {
			own.push_back(makeCell(number, width));
			own.back().begin = int(i);
		}
		own.back().end = int(i) + 1;
		cells.vertices.push_back(keyed[i].vertex);
	}
	return cells;
}

} // namespace gpr
