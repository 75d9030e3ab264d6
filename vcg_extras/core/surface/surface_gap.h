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
#include <vector>

namespace gpr {

/// Where a triangle and the surface lie farthest apart.
struct Gap {
	float squared; ///< length; at first what is near enough
	Vec3f way;     ///< from the triangle to the surface
	Vec3f at;      ///< where on the triangle
};

/// How far a triangle lies from the surface: the largest of the distances of a lattice of points on
/// it, or what is near where none is larger. seed: faces of the surface near its corners.
Gap gapFromTriangle(const HalfEdgeMesh& surface, const std::array<Vec3f, 3>& triangle,
					const std::array<int, 3>& seed, float squaredNear);

/// Measures gaps between the faces of a result and the surface, from both sides: from the vertices
/// of the input that are closest to a face, and from a lattice of points on the face. Gaps shorter
/// than `near` are not measured.
class SurfaceGaps {
public:
	/// point: per vertex of the result, a point of the surface near it; it may change later on.
	SurfaceGaps(const Surface& surface, const ClosestFaceMap& map, const HalfEdgeMesh& result,
				const Buffer<SurfacePoint>& point, float near);

	Gap gapAt(int f) const;
	/// Whether the gap of f, squared, is at most `squared`, which is no less than near. What makes
	/// it quicker than gapAt: no nearest point is looked for beyond one that is near enough.
	bool isWithin(int f, float squared) const;
	/// Per face the squared length of its gap. From the face itself it is looked at only where a
	/// corner is farther off than what is near. Cost: a pass over the input's vertices, in
	/// parallel.
	Buffer<float> measureAll(Workers& workers) const;

private:
	const HalfEdgeMesh&         s_; ///< of the surface
	const ClosestFaceMap&       map_;
	const HalfEdgeMesh&         m_; ///< of the result
	const Buffer<SurfacePoint>& point_;
	float                       squaredNear_;

	Gap  nearEnough() const { return {squaredNear_, Vec3f(), Vec3f()}; }
	void lookFromSurface(int f, Gap& gap) const;
	void lookFromTriangle(int f, Gap& gap) const;
	bool isFarVertex(int v) const;
};

} // namespace gpr

#endif
