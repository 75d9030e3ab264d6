// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_CONNECT_H
#define VCG_EXTRAS_CORE_MESH_CONNECT_H

#include "half_edge_mesh.h"
#include "indexed_mesh.h"
#include "spatial_order.h"

#include <vcg_extras/core/base/packed.h>
#include <vcg_extras/core/base/workers.h>

namespace gpr {

/// The input in the form of the engine: ordered, with half-edges. Sizes may split and cut it.
struct Surface {
	HalfEdgeMesh         mesh;
	Buffer<int>          sourceFace; ///< per face: the face of the input
	Buffer<PackedNormal> normal;     ///< per vertex, weighted by area (zero if undefined); marks:
									 ///< see pointedSpread, roughDeg and roughWidth
	Buffer<PackedMeasure> area; ///< per vertex: a third of the area of its faces, working units²
	Buffer<float>         size; ///< per vertex: see sizing.h; empty: even sizes
	Buffer<RingSum>       ring; ///< per vertex: see ringSum; for the sizes, and empty after these
	std::vector<Vec3f>    meetings; ///< see IndexedMesh
	Frame                 frame;
	MortonGrid            grid;
};

/// Bound of the spread of normals at the apex of a cone. The spread at a vertex is the length of
/// the sum of its faces' cross products over the sum of their lengths: 1 on flat ground, below this
/// bound on cones with this angle defect.
constexpr float spreadAtApex(float defectDeg)
{
	return 1.05f - defectDeg / 360;
}

/// Vertices with a smaller spread are marked as pointed.
constexpr float pointedSpread = spreadAtApex(30);

/// Vertices with two faces that meet at a larger angle, or with a face narrower than roughWidth
/// (working units), are marked as rough. Few vertices of most surfaces are rough, and searches for
/// crease edges and thin faces visit only rough vertices.
constexpr float roughDeg   = 30;
constexpr float roughWidth = 2e-6f;

/// Stage::Connect: builds the half-edge table of an ordered mesh (see orderSpatially), by listing
/// half-edges at their smaller end. If the mesh is manifold and consistently oriented, moves the
/// arrays out of `mesh` and returns true. Otherwise returns false and leaves `mesh` unchanged; for
/// repairManifold, surface.mesh.opposite then links the half-edges of edges with two faces in
/// opposite directions and is -1 for all other half-edges. keepsRings: fills surface.ring, too.
/// Cost: linear, parallel.
bool connect(IndexedMesh& mesh, const Buffer<int>& faceStart, Workers& workers, Surface& surface,
			 bool keepsRings = false);

/// Marks vertices with several fans (1), given linked half-edges. After a failed connect() these
/// are all faulty vertices: an edge without two faces in opposite directions has no opposites, so
/// that fans end at both its ends. Cost: linear, parallel.
Buffer<char> findNotManifold(const IndexedMesh& mesh, const Buffer<int>& opposite,
							 Workers& workers);

/// Fills the normal and the area of a vertex, and its ring if kept; returns the number of faces
/// round the vertex.
int measureVertex(int v, Surface& surface);

/// Moves the arrays of a surface back into a mesh that may be changed and connected anew. The
/// surface keeps only its frame.
IndexedMesh disconnect(Surface& surface);

/// A copy of a surface, without rings. Cost: a copy of its memory, parallel.
Surface copyOf(const Surface& from, Workers& workers);

} // namespace gpr

#endif
