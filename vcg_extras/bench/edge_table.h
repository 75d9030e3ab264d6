// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_EDGE_TABLE_H
#define VCG_EXTRAS_BENCH_EDGE_TABLE_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>

#include <cstdint>
#include <vector>

namespace gpr::bench {

/// The edges of a set of triangles, manifold or not. Side s of a mesh runs from triangles[s] to the
/// next corner of face s / 3.
struct EdgeTable {
	int         edgeNum = 0;
	Buffer<int> edgeOfSide; ///< per side
	Buffer<int> firstSide;  ///< per edge: its first side
	Buffer<int> sideNum;    ///< per edge: number of its faces
};

/// Numbers the edges by their smaller ends. Cost: linear for vertices of few faces.
EdgeTable findEdges(const std::vector<std::int32_t>& triangles, std::size_t vertexNum,
					Workers& workers);

/// The vertex at the end of a side.
inline std::int32_t endOfSide(const std::vector<std::int32_t>& triangles, int side)
{
	return triangles[side % 3 == 2 ? side - 2 : side + 1];
}

} // namespace gpr::bench

#endif
