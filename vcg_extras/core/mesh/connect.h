// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_CONNECT_H
#define VCG_EXTRAS_CORE_MESH_CONNECT_H

#include "half_edge_mesh.h"
#include "indexed_mesh.h"
#include "spatial_order.h"

#include <vcg_extras/core/base/packed_normal.h>
#include <vcg_extras/core/base/workers.h>

namespace gpr {

/// The input as the engine works on it: ordered, with half-edges. Never changed once it is
/// built.
struct Surface {
	HalfEdgeMesh         mesh;
	Buffer<int>          sourceFace; ///< per face: the caller's face it is part of
	Buffer<PackedNormal> normal;     ///< per vertex, area-weighted (zero where undefined); its
									 ///< marks: see pointedSpread, roughDeg and roughWidth
	Buffer<float>      size;         ///< per vertex: see sizing.h; empty: the same everywhere
	std::vector<Vec3f> meetings;     ///< see IndexedMesh
	Frame              frame;
	MortonGrid         grid;
};

/// How far the normals of the faces round a vertex spread: the length of the sum of their cross
/// products over the sum of the lengths is 1 on flat ground, and below this at the apex of any cone
/// that lacks so many degrees.
constexpr float spreadAtApex(float defectDeg)
{
	return 1.05f - defectDeg / 360;
}

/// Vertices with a spread below this are marked as pointed.
constexpr float pointedSpread = spreadAtApex(30);

/// Vertices at which two faces meet at more than this, or one is narrower than that in working
/// units, are marked as rough: few on most surfaces, and all that searches for sharp edges and thin
/// faces need to look at.
constexpr float roughDeg   = 30;
constexpr float roughWidth = 2e-6f;

/// Stage::Connect: half-edge table of an ordered mesh (see orderSpatially) by bucketing half-edges
/// at their smaller end. Moves the arrays out of `mesh` when all is manifold and consistently
/// oriented, and returns true; otherwise returns false and leaves `mesh` as it was. Then
/// surface.mesh.opposite tells, for repairManifold, which half-edges are the two of an edge with
/// faces in opposite directions; the others have -1. Cost: linear, parallel.
bool connect(IndexedMesh& mesh, const Buffer<int>& faceStart, Workers& workers, Surface& surface);

/// Which vertices (1) have more than one fan, where some half-edges are joined. Where connect()
/// failed, these are all that are to blame: an edge that is not shared by two faces in opposite
/// directions was left without opposites, so that at its ends fans end that do not end there.
/// Cost: linear, parallel.
Buffer<char> findNotManifold(const IndexedMesh& mesh, const Buffer<int>& opposite,
							 Workers& workers);

/// What Surface::normal holds for a vertex.
PackedNormal vertexNormal(const HalfEdgeMesh& mesh, int v);

/// Moves the surface's arrays back into a mesh that may be changed and connected anew. Nothing is
/// left of the surface but its frame.
IndexedMesh disconnect(Surface& surface);

/// The same surface once more. Cost: as that of its memory, parallel.
Surface copyOf(const Surface& from, Workers& workers);

} // namespace gpr

#endif
