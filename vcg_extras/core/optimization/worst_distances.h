// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_WORST_DISTANCES_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_WORST_DISTANCES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/closest_face_map.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

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
/// Changes positions; the surface points of the records stay. Returns the largest distance left, or
/// the distance that counts as near. map: of the mesh, or of a mesh with vertices nearby. Cost: a
/// pass over the vertices of the input, in parallel, and some hundred microseconds for each of the
/// few faces.
float lowerWorstDistances(const Surface& surface, const ClosestFaceMap& map, float minAngle,
						  int rounds, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
