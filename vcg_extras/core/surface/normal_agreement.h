// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_NORMAL_AGREEMENT_H
#define VCG_EXTRAS_CORE_SURFACE_NORMAL_AGREEMENT_H

#include "result_mesh.h"
#include "surface_point.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

namespace gpr {

/// Smooth normal of the working surface at a point: the mean of the vertex normals of its face.
/// Steadier than the face's own normal on noisy scans.
Vec3f smoothNormal(const Surface& surface, const SurfacePoint& point);

/// smoothNormal of every vertex of the result.
Buffer<Vec3f> smoothNormals(const Surface& surface, const ResultMesh& result, Workers& workers);

/// Normal agreement of a face: the cosine of the angle between its normal and the mean of its
/// corners' smooth normals; -1 for a degenerate face, below 0 for an inverted face.
float normalAgreement(const HalfEdgeMesh& mesh, const Buffer<Vec3f>& smoothNormal, int face);

/// The smooth normals of all vertices of the result, with withoutLip at the border: a lip at the
/// border, narrower than a triangle, may look away from the surface beside the lip.
Buffer<Vec3f> normalsWithoutLips(const Surface& surface, const ResultMesh& result,
								 Workers& workers);

/// The mean normal of the inner vertices beside border vertex v if `own` points against this mean,
/// else `own`.
Vec3f withoutLip(const HalfEdgeMesh& m, const Buffer<Vec3f>& normal, int v, const Vec3f& own);

/// Number of inverted faces: faces with a normal agreement below 0.
int invertedFaceNum(const Surface& surface, const ResultMesh& result, Workers& workers);

/// Cosine of the angle between two vectors; -1 if either is zero.
float agreement(const Vec3f& a, const Vec3f& b);

} // namespace gpr

#endif
