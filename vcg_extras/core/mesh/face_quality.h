// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_FACE_QUALITY_H
#define VCG_EXTRAS_CORE_MESH_FACE_QUALITY_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/base/workers.h>

#include <vector>

namespace gpr {

/// Smallest angle of a face in radians; 0 if degenerate.
float smallestAngle(const HalfEdgeMesh& m, int face);

/// Largest angle of a face in radians; 0, at less cost, if the face is not obtuse.
float obtuseAngle(const HalfEdgeMesh& m, int face);

/// Smallest angle in the star of v with v at p; below 0 if the move rotates a normal by a right
/// angle or more.
float smallestAngleAround(const HalfEdgeMesh& m, int v, const Vec3f& p);

/// Tests faces for angles below a limit (radians, at most 60°). Cost: a few products a face; the
/// angle is computed only if the edge lengths do not decide.
class PoorFaceTest {
public:
	PoorFaceTest(const HalfEdgeMesh& mesh, float limit);

	/// Whether a face is alive and has a smaller angle than the limit.
	bool operator()(int face) const;
	/// The smallest angle of a face, or the limit if no angle is smaller.
	float angleOrLimit(int face) const;

private:
	const HalfEdgeMesh& m_;
	float               limit_;
	float squaredRatio_; ///< of shortest over longest edge: no more with such an angle
};

/// The faces that PoorFaceTest finds, ascending.
std::vector<int> findPoorFaces(const HalfEdgeMesh& mesh, float angle, Workers& workers);
/// The poor faces among the given faces.
std::vector<int> poorOnes(const HalfEdgeMesh& mesh, float angle, const std::vector<int>& faces);

/// Finds living faces with a larger angle than `angle` (radians, at least 90°), ascending.
std::vector<int> findObtuseFaces(const HalfEdgeMesh& mesh, float angle, Workers& workers);

/// Bounds for flips that improve valences: the least angle, which a relaxation can still raise, and
/// the least cosine of the angle between the two normals.
constexpr float minFlipAngle = 17 * radians, minFlipCosine = 0.8f;

/// Whether flipping h makes sound faces: not inverted, with angles of at least minFlipAngle, and
/// with normals within minFlipCosine.
bool flipKeepsShape(const HalfEdgeMesh& m, int h);

/// Whether the area of a living face is mere rounding.
bool hasNoArea(const HalfEdgeMesh& mesh, int face);

/// Area of all faces, mesh units squared.
double surfaceArea(const HalfEdgeMesh& mesh, Workers& workers);

/// Edge length of equilateral triangles with the mean area of the faces.
float meanEdgeByArea(const HalfEdgeMesh& mesh, Workers& workers);

} // namespace gpr

#endif
