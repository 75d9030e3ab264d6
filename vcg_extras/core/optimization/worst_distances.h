// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_WORST_DISTANCES_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_WORST_DISTANCES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/closest_face_map.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Last part of Stage::Fit: where result and surface lie farthest apart, vertices are moved so that
/// they come closer. The fit minimises a mean of squares over the vertices of the input: a vertex
/// on a sharp ridge may stand far out from it, where hardly any vertex of the input sees it, and a
/// tip may be cut off.
///
/// Distances are looked at from both sides: from the vertices of the input closest to a triangle,
/// and, where it has a corner that is not near, from a lattice of points on the triangle. At the
/// faces that are more than three quarters as far off as the farthest one, farthest first, the
/// corners move along the way between the two surfaces there, a little at a time; a move stands if
/// that distance shrinks and none round it becomes larger than the largest there was, and if no
/// face turns, looks away from the surface or gets a smaller angle than minAngle (radians, or
/// than it had). So it goes on for so many rounds, or until all lie within a tenth of an edge.
/// Vertices of curves, cone apexes and pinned vertices stay.
///
/// Changes positions, and surface points, which come to lie at the nearest point. Returns the
/// largest distance that is left, or what counts as near. map: of the mesh, or of one whose
/// vertices lay near. Cost: a pass over the input's vertices, in parallel, and some hundred
/// microseconds for each of the few faces.
float lowerWorstDistances(const Surface& surface, const ClosestFaceMap& map, float minAngle,
						  int rounds, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
