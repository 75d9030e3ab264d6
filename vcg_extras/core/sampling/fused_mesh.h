// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_FUSED_MESH_H
#define VCG_EXTRAS_CORE_SAMPLING_FUSED_MESH_H

#include "front_sampling.h"

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// The mutual tessellation (paper §3, figure 1): the surface with every sample as a vertex, made by
/// edge splits. Vertices of the surface keep their numbers, new vertices follow. Every face lies in
/// one face of the surface, so shape and topology stay the same.
struct FusedMesh {
	HalfEdgeMesh     mesh;
	Buffer<int>      parentFace;   ///< at least mesh.faceNum entries: the face of the surface
	std::vector<int> sampleVertex; ///< per sample: its vertex, no two alike; -1: none
};

/// Begins a fusion: the surface itself, with no sample yet. Cost: a copy, in parallel.
FusedMesh beginFusion(const Surface& surface, Workers& workers);

/// Reserves memory for more vertices and for the faces of their splits.
void makeRoom(FusedMesh& fused, int moreVertices);

/// Splits the edge h, inner or border, at `place` (paper §3, step 6). Returns the new vertex, the
/// last of the mesh. The rest of h still begins at origin[h]. Reserves memory if needed.
int splitAt(FusedMesh& fused, int h, const Vec3f& place);

/// Makes every border sample a vertex: the border vertex at its place, or a new vertex on its
/// border edge. Appends to sampleVertex, in the order of boundary.samples. Needs a mesh whose
/// border edges are still the segments of the curves. Cost: linear in the samples of the border.
void fuseBoundary(const BoundaryCurves& boundary, FusedMesh& fused);

/// Fuses samples of any placement into the surface (paper §3, step 6): each sample becomes the
/// vertex at its place, or splits its edge in two or its face in three. A sample is at a vertex or
/// an edge within a thousandth of the face, the limit of rounding; the vertex then moves to the
/// sample. If `boundary` has samples, these and no others become vertices of the border. A sample
/// that falls on an earlier sample, or on the border without belonging there, gets no vertex: its
/// sampleVertex is -1.
///
/// Differs from the paper: its samples lie on edges and need edge splits only. Cost: a copy of the
/// surface, and a few faces a sample.
FusedMesh fuseSamples(const Surface& surface, const Sampling& sampling,
					  const BoundaryCurves& boundary, Workers& workers);

} // namespace gpr

#endif
