// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_WALK_H
#define VCG_EXTRAS_CORE_SURFACE_WALK_H

#include "result_mesh.h"
#include "surface_point.h"

#include <array>
#include <vector>

namespace gpr {

/// Most faces to cross in a walk if the caller knows no better bound.
constexpr int maxFacesCrossed = 20000;

/// Traces a straight geodesic: moves `at` by the vector `step`, turned into the plane of the face
/// and kept at its length, with unfolding across every edge on the way. The point stays on the
/// surface: no projection, and no other sheet. False if the walk ends early: at the border, before
/// or in a degenerate face, or after maxCrossings. Cost: the faces crossed.
bool walk(const HalfEdgeMesh& m, SurfacePoint& at, const Vec3f& step,
		  int maxCrossings = maxFacesCrossed);

/// Moves the record of a vertex by a walk. The step must be perpendicular to the record's normal.
bool walkBy(const Surface& surface, const Vec3f& step, ResultVertex& vertex);

/// Moves the record of vertex v below the vertex, after a move of the vertex off the surface: by a
/// walk, or to the nearest point of the same sheet if the walk ends farther from the vertex.
void followOnSurface(const Surface& surface, int v, ResultMesh& result);

/// The faces of a point: its own face, and up to rounding all faces at the point's edge or corner.
/// On a crease, a walk may go wrong from any but one of these faces.
std::vector<int> facesAt(const HalfEdgeMesh& m, const SurfacePoint& at);

/// Eight unit vectors perpendicular to a unit normal, an eighth of a turn apart: the directions of
/// a pattern search on the surface.
std::array<Vec3f, 8> compassDirections(const Vec3f& normal);

} // namespace gpr

#endif
