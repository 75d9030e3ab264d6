// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_ORACLES_H
#define GPR_TESTS_SUPPORT_ORACLES_H

#include <vcg_extras/core/mesh_view.h>

#include <cmath>
#include <vector>

namespace gpr::test {

// Slow answers that are right by construction, and geodesic distances in closed form.

struct NearestPair {
	int    first = -1, second = -1;
	double distance = HUGE_VAL; ///< straight through space
};

/// The two points nearest to each other, by comparing all.
NearestPair nearestPair(const std::vector<Vec3d>& points);
/// The number of pairs of points nearer to each other than `distance`, by comparing all.
int pairsNearerThan(const std::vector<Vec3d>& points, double distance);
/// Distance from p to the nearest of the points, straight through space.
double distanceToNearest(const std::vector<Vec3d>& points, const Vec3d& p);

/// Distance from p to a triangle, a segment, and to the nearest face of a mesh.
double distanceToTriangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c);
double distanceToSegment(const Vec3d& p, const Vec3d& a, const Vec3d& b);
double distanceToMesh(const TriangleMesh& mesh, const Vec3d& p);

/// Ends of the edges with one face, two points for each edge.
std::vector<Vec3d> rimSegments(const TriangleMesh& mesh);
/// Largest distance from one rim (ends, and points between the ends) to the other rim, in one
/// direction.
double rimDistance(const TriangleMesh& from, const TriangleMesh& to);

/// Ends of the edges whose faces' normals differ by more than angleDeg, two points for each edge.
std::vector<Vec3d> sharpSegments(const TriangleMesh& mesh, double angleDeg);
/// The segments of connected pieces with a length of at least minLength.
std::vector<Vec3d> withoutShortPieces(const std::vector<Vec3d>& segments, double minLength);
/// Largest distance from the segments `from` (ends, and points between the ends) to the segments
/// `to`.
double segmentDistance(const std::vector<Vec3d>& from, const std::vector<Vec3d>& to);

/// Great-circle distance on the sphere about the origin with both points.
double onSphere(const Vec3d& a, const Vec3d& b);
/// Distance on a cylinder about the z axis: straight on the unrolled surface.
double onCylinder(const Vec3d& a, const Vec3d& b, double radius);

} // namespace gpr::test

#endif
