// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_FUSED_MESH_H
#define VCG_EXTRAS_CORE_SAMPLING_FUSED_MESH_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// The mutual tessellation (paper §3, figure 1): the surface with every sample made a vertex of it
/// by edge splits. The surface's own vertices keep their numbers, new ones follow; every face lies
/// in one face of the surface, so that nothing has moved and topology is the surface's.
struct FusedMesh {
	HalfEdgeMesh     mesh;
	Buffer<int>      parentFace;   ///< of at least mesh.faceNum: the surface's face it lies in
	std::vector<int> sampleVertex; ///< per sample: its vertex, no two alike; -1: none
};

/// The surface itself: a tessellation with no sample fused yet. Cost: a copy, in parallel.
FusedMesh beginFusion(const Surface& surface, Workers& workers);

/// Makes room for so many more vertices and the faces that their splits need.
void makeRoom(FusedMesh& fused, int moreVertices);

/// Splits the edge h, inner or border, at a place on it (paper §3, step 6): the new vertex, which
/// is the mesh's last. What is left of h still begins at origin[h]. Makes room where there is none.
int splitAt(FusedMesh& fused, int h, const Vec3f& place);

/// Splits face f in three at a place inside; as splitAt else.
int splitFaceAt(FusedMesh& fused, int f, const Vec3f& place);

/// Makes every border sample a vertex: the border vertex it lies on, or a new one on its border
/// edge. Appends to sampleVertex, in the order of boundary.samples. Needs a mesh whose border edges
/// are still those of the curves. Cost: linear in the border's samples.
void fuseBoundary(const BoundaryCurves& boundary, FusedMesh& fused);

} // namespace gpr

#endif
