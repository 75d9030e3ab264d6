// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_SURFACE_RAY_H
#define VCG_EXTRAS_CORE_SURFACE_SURFACE_RAY_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>

namespace gpr {

/// A face laid into the plane of a ray. A ray is a unit vector with y > 0. It begins at 0, the
/// midpoint of an edge on the x axis:
///
///              c              The ray comes in over a -> b, with the face to the left of the edge,
///            /   \.           and leaves over c -> a if c is to the right of the ray, else over
///      out  /  .   \.         b -> c.
///          a --|--> b
///              0
struct UnfoldedFace {
	int   halfEdge; ///< a -> b
	Vec3f a, b, c;  ///< on the surface
	Vec2f a2, b2, c2;
	Vec3f cross; ///< of the face: two areas times the unit normal
	float doubleArea;

	/// The face of h, with the midpoint of h at 0 and h along the axis. c is unknown so far.
	UnfoldedFace(const HalfEdgeMesh& m, int h) :
			halfEdge(h), a(m.position[m.origin[h]]), b(m.position[m.target(h)])
	{
		const float half = 0.5f * length(b - a);
		a2               = {-half, 0};
		b2               = {half, 0};
	}
	UnfoldedFace() = default;

	/// False if a and b coincide.
	bool unfoldApex(const HalfEdgeMesh& m)
	{
		const Vec3f ab      = b - a;
		const float squared = squaredLength(ab);
		if (!(squared > 0)) return false;
		c          = m.position[m.apex(halfEdge)];
		cross      = gpr::cross(ab, c - a);
		doubleArea = length(cross);

		const float u = dot(c - a, ab) / squared, v = doubleArea / squared;
		const Vec2f ab2 = b2 - a2;
		c2              = {a2.x + u * ab2.x - v * ab2.y, a2.y + u * ab2.y + v * ab2.x};
		return true;
	}
	bool apexIsLeftOf(Vec2f ray) const { return ray.x * c2.y > ray.y * c2.x; }

	/// The half-edge by which a ray leaves: over b -> c, or else over c -> a.
	int exit(bool overBC) const { return overBC ? nextInFace(halfEdge) : prevInFace(halfEdge); }
	/// Makes this the neighbour over an edge, with an unknown apex; false at a border.
	bool goOver(bool overBC, const HalfEdgeMesh& m)
	{
		(overBC ? a : b)   = c;
		(overBC ? a2 : b2) = c2;
		halfEdge           = m.opposite[exit(overBC)];
		return halfEdge >= 0;
	}
};

/// Place along the ray of its crossing with the edge p -> q, from right to left. At least `from`,
/// in spite of rounding.
inline float crossingOf(Vec2f ray, Vec2f p, Vec2f q, float from)
{
	const Vec2f pq    = q - p;
	const float slope = cross(ray, pq);
	const float at    = slope > 0 ? cross(p, pq) / slope : from;
	return at > from ? at : from;
}

/// Follows a straight geodesic from the midpoint of half-edge h into its face and on. Calls
/// visit(exit, at) for each edge crossed within `reach`: exit is the half-edge of the face left by
/// the ray, at the length along the ray. Cost: the faces crossed, at most maxCrossings.
template <class Visit>
void traceRay(const HalfEdgeMesh& m, int h, Vec2f ray, float reach, int maxCrossings,
			  const Visit& visit)
{
	UnfoldedFace f(m, h);
	float        at = 0;
	for (int crossings = 0; crossings < maxCrossings; ++crossings) {
		if (!f.unfoldApex(m)) return;
		const bool overBC = f.apexIsLeftOf(ray);
		at = overBC ? crossingOf(ray, f.b2, f.c2, at) : crossingOf(ray, f.c2, f.a2, at);
		if (at >= reach) return;
		visit(f.exit(overBC), at);
		if (!f.goOver(overBC, m)) return;
	}
}

} // namespace gpr

#endif
