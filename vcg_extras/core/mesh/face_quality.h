// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_FACE_QUALITY_H
#define VCG_EXTRAS_CORE_MESH_FACE_QUALITY_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/base/workers.h>

#include <vector>

namespace gpr {

/// Smallest angle of a face in radians; 0 where it has no area.
float smallestAngle(const HalfEdgeMesh& m, int face);

/// Largest angle of a face in radians; 0 where it is not obtuse, which costs less to tell.
float obtuseAngle(const HalfEdgeMesh& m, int face);

/// Smallest angle in the ring of v with v at p; below 0 if a face turns so far by the move that the
/// cosine is turnCosine or less.
float smallestAngleAround(const HalfEdgeMesh& m, int v, const Vec3f& p, float turnCosine);

/// Living faces with a smaller angle than this (radians, at most 60°), ascending. Cost: a few
/// products a face; the angle itself is only worked out where the edges leave it open.
std::vector<int> findPoorFaces(const HalfEdgeMesh& mesh, float angle, Workers& workers);
/// Those of the given faces.
std::vector<int> poorOnes(const HalfEdgeMesh& mesh, float angle, const std::vector<int>& faces);

/// Living faces with a larger angle than this (radians, at least 90°), ascending. Cost: as above.
std::vector<int> findObtuseFaces(const HalfEdgeMesh& mesh, float angle, Workers& workers);

/// What a flip that changes valences may leave: an angle (radians), which a relaxation can still
/// raise, and the cosine of the angle between the two faces.
constexpr float minFlipAngle = 17 * radians, minFlipCosine = 0.8f;

/// Whether the faces that flipping h would make are sound: not turned over, no angle below
/// minFlipAngle, and no larger angle between them than minFlipCosine says.
bool flipKeepsShape(const HalfEdgeMesh& m, int h);

/// Whether the area of a living face is nothing but rounding.
bool hasNoArea(const HalfEdgeMesh& mesh, int face);

/// Area of all faces, squared units of the mesh.
double surfaceArea(const HalfEdgeMesh& mesh, Workers& workers);

/// Edge of equilateral triangles of the faces' mean area.
float meanEdgeByArea(const HalfEdgeMesh& mesh);

} // namespace gpr

#endif
