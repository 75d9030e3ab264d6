// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_RAY_H
#define VCG_EXTRAS_CORE_SURFACE_RAY_H

#include "half_edge_mesh.h"

#include <cmath>

namespace gpr {

/// How a ray over the surface ended.
enum class RayEnd {
	Arrived,
	AtBorder, ///< or before an edge without length
	Capped,   ///< crossed mostCrossings faces
};

/// A direction in the plane of a face, measured from one of its edges: counter-clockwise from the
/// half-edge, in (0, π).
struct RayDirection {
	float cosine;
	float sine; ///< > 0
};

namespace detail {

struct Vec2 {
	float x, y;
};
inline Vec2 operator-(Vec2 a, Vec2 b)
{
	return {a.x - b.x, a.y - b.y};
}
inline float cross(Vec2 a, Vec2 b)
{
	return a.x * b.y - a.y * b.x;
}

/// A triangle unfolded into the plane of the ray's beginning, lying to the left of a -> b.
struct UnfoldedFace {
	int   halfEdge; ///< a -> b, where the ray came in
	Vec3f a, b, c;  ///< on the surface
	Vec2  a2, b2, c2;
	Vec3f cross; ///< two areas times the unit normal
	float doubleArea;

	/// False where a and b coincide.
	bool unfoldApex(const HalfEdgeMesh& m)
	{
		const Vec3f ab      = b - a;
		const float squared = squaredLength(ab);
		if (!(squared > 0)) return false;
		c             = m.position[m.apex(halfEdge)];
		cross         = gpr::cross(ab, c - a);
		doubleArea    = length(cross);
		const float u = dot(c - a, ab) / squared, v = doubleArea / squared;
		const Vec2  ab2 = b2 - a2;
		c2              = {a2.x + u * ab2.x - v * ab2.y, a2.y + u * ab2.y + v * ab2.x};
		return true;
	}
};

} // namespace detail

/// Follows a straight geodesic from the midpoint of half-edge h into its face and on, unfolding
/// every face crossed into one plane. Calls visit(cross, doubleArea, from, to, exit) for each face:
/// its unnormalised normal and that one's length, where along the ray the face begins and ends, and
/// the half-edge of the face through which the ray leaves it (also where `to` is cut to `reach`).
/// Cost: the faces crossed, at most mostCrossings.
template <class Visit>
RayEnd traceRay(const HalfEdgeMesh& m, int h, RayDirection direction, float reach,
				int mostCrossings, const Visit& visit)
{
	using detail::Vec2;
	const Vec2           d{direction.cosine, direction.sine};
	detail::UnfoldedFace f;
	f.halfEdge       = h;
	f.a              = m.position[m.origin[h]];
	f.b              = m.position[m.target(h)];
	const float half = 0.5f * length(f.b - f.a);
	f.a2             = {-half, 0};
	f.b2             = {half, 0};
	float from       = 0;
	for (int crossings = 0; crossings < mostCrossings; ++crossings) {
		if (!f.unfoldApex(m)) return RayEnd::AtBorder;
		const bool  apexIsLeft = detail::cross(d, f.c2) > 0;
		const int   exit       = apexIsLeft ? nextInFace(f.halfEdge) : prevInFace(f.halfEdge);
		const Vec2  p          = apexIsLeft ? f.b2 : f.c2;
		const Vec2  q          = apexIsLeft ? f.c2 : f.a2;
		const float slope      = detail::cross(d, q - p);
		// Rounding may put the crossing a little before the last one.
		float to = slope > 0 ? detail::cross(p, q - p) / slope : from;
		if (!(to > from)) to = from;
		visit(f.cross, f.doubleArea, from, to < reach ? to : reach, exit);
		if (to >= reach) return RayEnd::Arrived;
		const int other = m.opposite[exit];
		if (other < 0) return RayEnd::AtBorder;
		if (apexIsLeft) {
			f.a  = f.c;
			f.a2 = f.c2;
		}
		else {
			f.b  = f.c;
			f.b2 = f.c2;
		}
		f.halfEdge = other;
		from       = to;
	}
	return RayEnd::Capped;
}

} // namespace gpr

#endif
