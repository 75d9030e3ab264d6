// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_SPATIAL_ORDER_H
#define VCG_EXTRAS_CORE_MESH_SPATIAL_ORDER_H

#include "indexed_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <cstdint>

namespace gpr {

/// An octree over the bounding cube of a mesh; the width of a cell of level k is 2^-k of the cube.
struct MortonGrid {
	static constexpr int deepestLevel = 21;

	Vec3f low;
	float cubeSize = 1;
	int   level    = 0; ///< cells of this and higher levels are contiguous ranges of vertices

	/// Interleaved cell coordinates on the deepest level, 63 bits.
	std::uint64_t key(const Vec3f& p) const;
	/// The number of the cell on a level: the leading 3·level bits of the key.
	std::uint64_t cell(const Vec3f& p, int onLevel) const
	{
		return key(p) >> (3 * (deepestLevel - onLevel));
	}
	float cellSize(int onLevel) const { return cubeSize / float(1 << onLevel); }
};

/// A grid over a box, of level 0.
MortonGrid gridAround(const Box<float>& box);

/// Stage::Order: puts the vertices in Morton order, and the faces in the order of their smallest
/// vertex, which becomes their first corner (orientation kept). Neighbours then lie close in
/// memory, and an octree cell is a range of vertices, as threads need. Equal keys keep their order,
/// so the result does not depend on threads. faceStart (vertexNum + 1 entries) receives the begin
/// of the faces of each first corner. Cost: linear (radix sort), parallel.
MortonGrid orderSpatially(IndexedMesh& mesh, Workers& workers, Buffer<int>& faceStart);

/// Orders the faces only, for vertices that are in order.
void orderFaces(IndexedMesh& mesh, Workers& workers, Buffer<int>& faceStart);

} // namespace gpr

#endif
