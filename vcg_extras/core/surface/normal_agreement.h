// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_NORMAL_AGREEMENT_H
#define VCG_EXTRAS_CORE_SURFACE_NORMAL_AGREEMENT_H

#include "result_mesh.h"
#include "surface_point.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

namespace gpr {

/// The input's normal round a surface point: mean of the vertex normals of its face. Steadier than
/// the face's own normal on noisy scans.
Vec3f smoothNormal(const Surface& surface, const SurfacePoint& point);

/// smoothNormal of every vertex of the result.
Buffer<Vec3f> smoothNormals(const Surface& surface, const ResultMesh& result, Workers& workers);

/// Cosine of the angle between a face of the result and the mean of its corners' smooth normals; -1
/// for a face without area. Below 0 the face looks the wrong way.
float normalAgreement(const HalfEdgeMesh& mesh, const Buffer<Vec3f>& smoothNormal, int face);
/// The same for a few faces, without the normals of all vertices.
float normalAgreement(const Surface& surface, const ResultMesh& result, int face);

/// The surface's normals at the vertices (smoothNormals), but at vertices of the border that lie on
/// a lip narrower than a triangle, which looks away from the surface beside it: the normal of that.
Buffer<Vec3f> normalsWithoutLips(const Surface& surface, const ResultMesh& result,
								 Workers& workers);

/// The mean normal of the vertices inside beside a vertex of the border if its own looks away from
/// it, else its own.
Vec3f withoutLip(const HalfEdgeMesh& m, const Buffer<Vec3f>& normal, int v, const Vec3f& own);

/// Number of inverted faces: those whose normals point against the surface's.
int invertedFaceNum(const Surface& surface, const ResultMesh& result, Workers& workers);

/// Cosine of the angle between two vectors; -1 where one is zero.
float agreement(const Vec3f& a, const Vec3f& b);

} // namespace gpr

#endif
