// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_SURFACE_GAP_H
#define VCG_EXTRAS_CORE_SURFACE_SURFACE_GAP_H

#include "closest_face_map.h"
#include "surface_point.h"

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <array>
#include <cmath>

namespace gpr {

/// The largest distance between a triangle and the surface.
struct Gap {
	float squared; ///< squared length; at first the length that counts as near enough
	Vec3f way;     ///< from the triangle to the surface
	Vec3f at;      ///< place on the triangle
};

/// Largest distance of a triangle from the surface, measured at a lattice of points of the
/// triangle; squaredNear if no distance is larger. seed: faces of the surface near the corners of
/// the triangle. squaredMost: a larger distance ends the search.
Gap gapFromTriangle(const HalfEdgeMesh& surface, const std::array<Vec3f, 3>& triangle,
					const std::array<int, 3>& seed, float squaredNear,
					float squaredMost = HUGE_VALF);

/// Measures gaps between the faces of a result and the surface in both directions: from the closest
/// vertices of the surface to each face, and from a lattice of points of the face. Gaps shorter
/// than `near` are not measured.
class SurfaceGaps {
public:
	/// point: per vertex of the result, a point of the surface near the vertex; may change later
	/// on.
	SurfaceGaps(const Surface& surface, const ClosestFaceMap& map, const HalfEdgeMesh& result,
				const Buffer<SurfacePoint>& point, float near);

	/// squaredMost: see gapFromTriangle.
	Gap gapAt(int f, float squaredMost = HUGE_VALF) const;
	/// Whether the squared gap of f is at most `squared`; `squared` is at least near². Quicker than
	/// gapAt: each search ends at a point that is near enough.
	bool isWithin(int f, float squared) const;
	/// Per face the squared length of its gap. Measures from the face only if a corner is farther
	/// off than near. Cost: a pass over the surface's vertices, in parallel.
	Buffer<float> measureAll(Workers& workers) const;

private:
	const HalfEdgeMesh&         s_; ///< of the surface
	const ClosestFaceMap&       map_;
	const HalfEdgeMesh&         m_; ///< of the result
	const Buffer<SurfacePoint>& point_;
	float                       squaredNear_;

	Gap  nearEnough() const { return {squaredNear_, Vec3f(), Vec3f()}; }
	void lookFromSurface(int f, Gap& gap) const;
	void lookFromTriangle(int f, Gap& gap, float squaredMost) const;
	bool isFarVertex(int v) const;
};

} // namespace gpr

#endif
