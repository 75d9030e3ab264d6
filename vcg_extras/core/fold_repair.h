// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FOLD_REPAIR_H
#define VCG_EXTRAS_CORE_FOLD_REPAIR_H

#include "boundary_curves.h"
#include "connect.h"
#include "result_mesh.h"
#include "workers.h"

namespace gpr {

/// The input's normal round an anchor: mean of the vertex normals of its face. Steadier than the
/// face's own normal on noisy scans.
Vec3f smoothNormal(const Surface& surface, const Anchor& anchor);

/// smoothNormal of every vertex of the result.
Buffer<Vec3f> smoothNormals(const Surface& surface, const ResultMesh& result, Workers& workers);

/// Cosine of the angle between a face of the result and the mean of its corners' smooth normals; -1
/// for a face without area. Below 0 the face looks the wrong way.
float faceAgreement(const HalfEdgeMesh& mesh, const Buffer<Vec3f>& smoothNormal, int face);
/// The same for a few faces, without the normals of all vertices.
float faceAgreement(const Surface& surface, const ResultMesh& result, int face);

/// Where the surface is thinner than the triangles (fingers, lips, thin plates) removal can leave
/// faces that look against the surface. Each such face, and its neighbours, is mended by the flip,
/// move or collapse that helps most, one after the other, until none is left or none helps. Border
/// vertices move along their curve only, and stay between their neighbours. mayCollapse: whether
/// vertices may go, which only the exact count makes good again. Returns the number of faces that
/// still look the wrong way, or nearly. Cost: a pass over the faces a round, and the few faces
/// concerned.
int mendFolds(const Surface& surface, const BoundaryCurves& boundary, bool mayCollapse,
			  ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
