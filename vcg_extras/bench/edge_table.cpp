// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_table.h"

#include <vcg_extras/core/base/counting_sort.h>

#include <algorithm>

namespace gpr::bench {

namespace {

using Corners = std::vector<std::int32_t>;

int smallerEnd(const Corners& triangles, int side)
{
	return std::min(triangles[side], endOfSide(triangles, side));
}

int largerEnd(const Corners& triangles, int side)
{
	return std::max(triangles[side], endOfSide(triangles, side));
}

/// Groups sides of the same edge; all sides have the same smaller end.
void groupByEdge(const Corners& triangles, int* begin, int* end)
{
	std::stable_sort(begin, end, [&](int a, int b) {
		return largerEnd(triangles, a) < largerEnd(triangles, b);
	});
}

} // namespace

EdgeTable findEdges(const Corners& triangles, std::size_t vertexNum, Workers& workers)
{
	Buffer<int> start, side;
	sortIntoBuckets(
		triangles.size(), vertexNum, [&](std::size_t s) { return smallerEnd(triangles, int(s)); },
		workers, start, side);
	workers.forRange(vertexNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v)
			groupByEdge(triangles, side.data() + start[v], side.data() + start[v + 1]);
	});

	EdgeTable table;
	table.edgeOfSide.reset(triangles.size());
	table.firstSide.reset(triangles.size());
	table.sideNum.reset(triangles.size());
	for (std::size_t i = 0; i < side.size(); ++i) {
		const bool sameEdge =
			i > 0 && smallerEnd(triangles, side[i]) == smallerEnd(triangles, side[i - 1]) &&
			largerEnd(triangles, side[i]) == largerEnd(triangles, side[i - 1]);
		if (!sameEdge) {
			table.firstSide[table.edgeNum] = side[i];
			table.sideNum[table.edgeNum]   = 0;
			++table.edgeNum;
		}
		table.edgeOfSide[side[i]] = table.edgeNum - 1;
		++table.sideNum[table.edgeNum - 1];
	}
	return table;
}

} // namespace gpr::bench
