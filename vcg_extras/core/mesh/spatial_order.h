// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_SPATIAL_ORDER_H
#define VCG_EXTRAS_CORE_MESH_SPATIAL_ORDER_H

#include "indexed_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <cstdint>

namespace gpr {

/// Octree over the mesh's bounding cube; a cell of level k is 2^-k of the cube wide.
struct MortonGrid {
	static constexpr int deepestLevel = 21;

	Vec3f low;
	float cubeSize = 1;
	int   level    = 0; ///< cells of this level and above are contiguous ranges of vertices

	/// Interleaved cell coordinates on the deepest level, 63 bits.
	std::uint64_t key(const Vec3f& p) const;
	/// The cell's number on a level: the leading 3·level bits of the key.
	std::uint64_t cell(const Vec3f& p, int onLevel) const
	{
		return key(p) >> (3 * (deepestLevel - onLevel));
	}
	float cellSize(int onLevel) const { return cubeSize / float(1 << onLevel); }
};

/// Stage::Order: puts the vertices in Morton order and the faces in the order of their smallest
/// vertex, which also becomes their first corner (orientation kept). Neighbours then lie close
/// together in memory, and a cell of the octree is one range of vertices, which is what threads are
/// given. Equal keys and faces keep their order, so the outcome does not depend on threads.
/// faceStart (vertexNum + 1 entries) receives where the faces of each first corner begin.
/// Cost: linear (radix and counting sort), parallel.
MortonGrid orderSpatially(IndexedMesh& mesh, Workers& workers, Buffer<int>& faceStart);

/// The faces' part of it, for vertices that are in a good order already.
void orderFaces(IndexedMesh& mesh, Workers& workers, Buffer<int>& faceStart);

} // namespace gpr

#endif
