// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_tree.h"

#include <vcg_extras/core/base/box.h>

#include <algorithm>

namespace gpr::app {

namespace {

/// The longest axis of the box of some points.
int longestAxis(const std::vector<Vec3d>& points, std::size_t begin, std::size_t end)
{
	Box<double> box;
	for (std::size_t i = begin; i < end; ++i)
		box.add(points[i]);
	const Vec3d size    = box.high - box.low;
	int         longest = 0;
	for (int axis = 1; axis < 3; ++axis)
		if (coordinate(size, axis) > coordinate(size, longest)) longest = axis;
	return longest;
}

} // namespace

CellTree::CellTree(std::vector<Vec3d>& points, int cellNum) : cellNum_(cellNum)
{
	points.erase(
		std::remove_if(points.begin(), points.end(), [](const Vec3d& p) { return !isFinite(p); }),
		points.end());
	build(points, 0, points.size(), 0, cellNum);
}

int CellTree::build(std::vector<Vec3d>& points, std::size_t begin, std::size_t end, int firstCell,
					int cellNum)
{
	if (cellNum == 1) return -1 - firstCell;
	const int         cellsBelow = cellNum / 2;
	const int         axis       = longestAxis(points, begin, end);
	const std::size_t middle =
		begin + (end - begin) * std::size_t(cellsBelow) / std::size_t(cellNum);
	const auto isBefore = [axis](const Vec3d& a, const Vec3d& b) {
		return coordinate(a, axis) < coordinate(b, axis);
	};
	const auto at    = [&](std::size_t i) { return points.begin() + std::ptrdiff_t(i); };
	double     value = 0;
	if (middle < end) {
		std::nth_element(at(begin), at(middle), at(end), isBefore);
		value = coordinate(points[middle], axis);
	}
	const int node = int(nodes_.size());
	nodes_.push_back({axis, value, 0, 0});
	const int below = build(points, begin, middle, firstCell, cellsBelow);
	const int above = build(points, middle, end, firstCell + cellsBelow, cellNum - cellsBelow);
	nodes_[std::size_t(node)].below = below;
	nodes_[std::size_t(node)].above = above;
	return node;
}

int CellTree::cellOf(const Vec3d& p) const
{
	if (nodes_.empty()) return 0;
	int node = 0;
	while (node >= 0) {
		const Node& n = nodes_[std::size_t(node)];
		node          = coordinate(p, n.axis) < n.value ? n.below : n.above;
	}
	return -1 - node;
}

} // namespace gpr::app
