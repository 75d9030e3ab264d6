// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_marks.h"

#include <algorithm>
#include <utility>

namespace gpr::python {

namespace {

/// An edge as its vertices in ascending order, with the number of the given edge.
struct GivenEdge {
	std::pair<std::int32_t, std::int32_t> vertices;
	std::int64_t                          number = 0;

	bool operator<(const GivenEdge& other) const { return vertices < other.vertices; }
};

std::pair<std::int32_t, std::int32_t> ascending(std::int32_t a, std::int32_t b)
{
	return {std::min(a, b), std::max(a, b)};
}

std::vector<GivenEdge> sorted(const std::int32_t* edges, std::size_t edgeNum)
{
	std::vector<GivenEdge> all(edgeNum);
	for (std::size_t e = 0; e < edgeNum; ++e)
		all[e] = {ascending(edges[2 * e], edges[2 * e + 1]), std::int64_t(e)};
	std::sort(all.begin(), all.end());
	return all;
}

} // namespace

std::int64_t markEdges(const MeshView& mesh, const std::int32_t* edges, std::size_t edgeNum,
					   std::vector<std::uint8_t>& marks)
{
	const std::vector<GivenEdge> all = sorted(edges, edgeNum);
	std::vector<char>            isFound(edgeNum, 0);
	marks.resize(3 * mesh.faceNum, 0);
	for (std::size_t c = 0; c < marks.size(); ++c) {
		const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
		const GivenEdge   edge = {ascending(mesh.vertexOf(c), mesh.vertexOf(next)), 0};
		const auto        same = std::equal_range(all.begin(), all.end(), edge);
		if (same.first == same.second) continue;
		marks[c] = 1;
		for (auto e = same.first; e != same.second; ++e)
			isFound[std::size_t(e->number)] = 1;
	}
	const auto missing = std::find(isFound.begin(), isFound.end(), 0);
	return missing == isFound.end() ? -1 : missing - isFound.begin();
}

} // namespace gpr::python
