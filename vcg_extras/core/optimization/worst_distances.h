// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_WORST_DISTANCES_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_WORST_DISTANCES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/closest_face_map.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// A point of the surface far from the result, or a point of the result far from the surface;
/// working units.
struct FarPoint {
	Vec3f position;
	float distance    = 0;
	bool  isOfSurface = false;
};

/// Last part of Stage::Fit: moves vertices at the places with the largest distances between result
/// and surface, so that the distances fall. The fit minimises a mean of squares over the vertices
/// of the input: a vertex on a sharp ridge may lie far outside, because few vertices of the input
/// see the vertex, and a tip may be cut off.
///
/// Distances are measured from both sides: from the vertices of the input closest to a triangle,
/// and, if a corner of the triangle is far, from a lattice of points on the triangle. At the faces
/// with more than three quarters of the largest distance, farthest first, the corners move along
/// the line between the two surfaces, in small steps. A move stands if the distance shrinks, if no
/// distance round the face becomes larger than the largest there before, and if no face turns,
/// looks away from the surface or gets a smaller angle than minAngle (radians, or than the face
/// had). The rounds end early if all distances are below a tenth of an edge. Vertices of curves,
/// cone apexes and pinned vertices stay.
///
/// goal: with a goal, in working units, all faces with a larger distance move, farthest first, and
/// vertices of feature lines may leave their lines by up to the goal; 0: no goal.
///
/// The records of moved free vertices follow on the surface. Returns the largest distance left, or
/// the distance that counts as near. map: of the mesh, or of a mesh with vertices nearby. Cost: a
/// pass over the vertices of the input, in parallel, and some hundred microseconds for each of the
/// few faces.
float lowerWorstDistances(const Surface& surface, const ClosestFaceMap& map, float minAngle,
						  int rounds, ResultMesh& result, Workers& workers, float goal = 0);

/// Draws the result to far points within a goal, by the same moves and with the same limits. Unlike
/// the vertices of the input, which lowerWorstDistances looks at, far points may lie anywhere: in
/// the middle of a long crease edge of the input, for example. Returns the points that stay farther
/// than the goal. Cost: a pass over the vertices of the input, a tree over the faces of the result,
/// and some hundred microseconds for each point.
std::vector<FarPoint> drawToPoints(const std::vector<FarPoint>& points, const Surface& surface,
								   const ClosestFaceMap& map, float minAngle, float goal,
								   ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
