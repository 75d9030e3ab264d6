// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_BORDER_SPLIT_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_BORDER_SPLIT_H

#include <vcg_extras/io/mesh/mesh_data.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace gpr::app {

/// The name of a vertex shared by several tiles: its number in the input, or the two numbers of an
/// edge and the position of the vertex between its ends.
struct SharedName {
	std::uint32_t low = none, high = none, part = 0;

	static constexpr std::uint32_t none = 0xffffffffu;

	bool isShared() const { return low != none; }
	bool operator==(const SharedName& o) const { return key() == o.key(); }
	bool operator<(const SharedName& o) const { return key() < o.key(); }
	std::tuple<std::uint32_t, std::uint32_t, std::uint32_t> key() const
	{
		return {low, high, part};
	}
	struct Hash {
		std::size_t operator()(const SharedName& n) const
		{
			const std::uint64_t both = std::uint64_t(n.high) << 32 | n.low;
			return std::size_t((both ^ n.part) * 0x9e3779b97f4a7c15u >> 7);
		}
	};
};

/// Splits the border edges of a tile longer than maxLength into equal pieces, so that triangles as
/// small as the result's fit beside the border. Edges at the same place get the same points, bit
/// for bit, in all tiles: the points depend on the positions of the ends and maxLength alone. The
/// surface stays the same, and repeated faces stay repeated. names: per vertex; receives names of
/// the new vertices. sharedOnly: edges without two shared ends, which lie on the border of the
/// input, stay. Cost: linear, and O(n log n) in the long border edges.
void splitLongBorderEdges(double maxLength, InputMesh& mesh, std::vector<SharedName>& names,
						  bool sharedOnly = false);

/// Two vertices of a mesh, the smaller number first.
using Edge = std::pair<std::int32_t, std::int32_t>;

/// The edges with a single face, repeated or not, ascending. Cost: linear.
std::vector<Edge> borderEdges(const MeshView& mesh);

} // namespace gpr::app

#endif
