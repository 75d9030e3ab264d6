// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_WALK_H
#define VCG_EXTRAS_CORE_SURFACE_WALK_H

#include "result_mesh.h"
#include "surface_point.h"

#include <array>
#include <vector>

namespace gpr {

/// How a walk ended.
enum class WalkEnd {
	Arrived,
	AtBorder, ///< stopped at the border, before a face without area or in one
	Capped,   ///< more faces crossed than any sensible walk does
};

/// Faces a walk crosses at most where the caller knows no better bound.
constexpr int maxFacesCrossed = 20000;

/// Traces a straight geodesic: moves `at` by the vector `step`, turned into the plane of its face
/// and kept at its length, unfolding across every edge on the way. The point stays on the surface,
/// so nothing has to be projected and no other sheet can be met. Cost: the faces crossed.
WalkEnd walk(const HalfEdgeMesh& m, SurfacePoint& at, const Vec3f& step,
			 int maxCrossings = maxFacesCrossed);

/// Moves the record of a vertex by a walk. The step must be tangential to the record's normal.
WalkEnd walkBy(const Surface& surface, const Vec3f& step, ResultVertex& vertex);

/// The faces that a point lies in: its own, and where it lies on an edge or in a corner of that, up
/// to rounding, all those that meet there. On a crease a walk goes wrong from all but one of them.
std::vector<int> facesAt(const HalfEdgeMesh& m, const SurfacePoint& at);

/// Eight unit vectors perpendicular to a unit normal, an eighth of a turn apart: the directions of
/// a pattern search on the surface.
std::array<Vec3f, 8> compassDirections(const Vec3f& normal);

} // namespace gpr

#endif
