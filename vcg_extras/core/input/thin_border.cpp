// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "thin_border.h"

#include "flat_pieces.h"

#include <vcg_extras/core/base/union_find.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>

#include <algorithm>
#include <array>

namespace gpr {

namespace {

/// Margin for computing widths again, in another frame, when the part is remeshed.
constexpr float margin = 2;
constexpr int   none   = -1;

bool isThinIn(const Frame& frame, const MeshView& input, std::size_t f)
{
	std::array<Vec3f, 3> corner;
	for (std::size_t k = 0; k < 3; ++k) {
		const Vec3d p = input.position(std::size_t(input.triangle(f)[k]));
		if (!isFinite(p)) return false; // dropped when the part is loaded
		corner[k] = frame.toWorking(p);
	}
	return isThin(corner[0], corner[1], corner[2], margin);
}

std::vector<std::size_t> findThin(const MeshView& input, const std::vector<std::uint8_t>& isInPart)
{
	std::vector<std::size_t> thin;
	const auto frame = frameOf(input, [&](std::size_t f) { return isInPart[f] != 0; });
	if (!frame) return thin;
	for (std::size_t f = 0; f < input.faceNum; ++f) {
		if (isInPart[f] && isThinIn(*frame, input, f)) thin.push_back(f);
	}
	return thin;
}

/// Per vertex its set for union_find.h: corners of the same thin face are in the same set; none for
/// all other vertices.
std::vector<int> linkCorners(const MeshView& input, const std::vector<std::size_t>& thin)
{
	std::vector<int> parent(input.vertexNum, none);
	for (std::size_t f : thin) {
		for (std::int32_t v : input.triangle(f))
			parent[v] = v;
	}
	for (std::size_t f : thin) {
		const auto corner = input.triangle(f);
		joinSets(parent, corner[0], corner[1]);
		joinSets(parent, corner[0], corner[2]);
	}
	return parent;
}

/// The corners of thin faces on the border of the part. Looks only at edges with an end at a thin
/// face: few edges.
std::vector<int> findBorderCorners(const MeshView& input, const std::vector<std::uint8_t>& isInPart,
								   const std::vector<int>& parent)
{
	const auto            isCorner = [&](int v) { return parent[v] != none; };
	std::vector<EdgeSide> sides;
	for (std::size_t c = 0; c < 3 * input.faceNum; ++c) {
		const EdgeSide side = edgeSide(input, c);
		if (isInPart[c / 3] && (isCorner(side.low) || isCorner(side.high))) sides.push_back(side);
	}
	std::sort(sides.begin(), sides.end());
	std::vector<int> found;
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		for (int v : {sides[begin].low, sides[begin].high}) {
			if (end - begin == 1 && isCorner(v)) found.push_back(v);
		}
	});
	return found;
}

} // namespace

void takeOutThinBorder(const MeshView& input, std::vector<std::uint8_t>& isInPart)
{
	std::vector<std::size_t> thin = findThin(input, isInPart);
	if (thin.empty()) return;
	std::vector<int>  parent = linkCorners(input, thin);
	std::vector<char> isAtBorder(input.vertexNum, 0); // per root
	for (int v : findBorderCorners(input, isInPart, parent))
		isAtBorder[rootOf(parent, v)] = 1;
	const auto stays = [&](std::size_t f) {
		return !isAtBorder[rootOf(parent, input.triangle(f)[0])];
	};
	thin.erase(std::remove_if(thin.begin(), thin.end(), stays), thin.end());
	const auto partNum = std::count(isInPart.begin(), isInPart.end(), std::uint8_t(1));
	if (std::ptrdiff_t(thin.size()) == partNum) return;
	for (std::size_t f : thin)
		isInPart[f] = 0;
}

} // namespace gpr
