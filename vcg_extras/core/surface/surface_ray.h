// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_SURFACE_RAY_H
#define VCG_EXTRAS_CORE_SURFACE_SURFACE_RAY_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>

namespace gpr {

/// The end of a ray over the surface.
enum class RayEnd {
	Arrived,
	AtBorder, ///< or before an edge without length
	Capped,   ///< crossed maxCrossings faces
};

/// A direction in the plane of a face, measured from one of its edges: counter-clockwise from the
/// half-edge, in (0, π).
struct RayDirection {
	float cosine;
	float sine; ///< > 0
};

struct PlanePoint {
	float x, y;
};
inline PlanePoint operator-(PlanePoint a, PlanePoint b)
{
	return {a.x - b.x, a.y - b.y};
}
inline float cross(PlanePoint a, PlanePoint b)
{
	return a.x * b.y - a.y * b.x;
}

/// A face laid into the plane of a ray, with the ray's begin at 0:
///
///              c              The ray comes in over a -> b, with the face to the left of the edge,
///            /   \.           and leaves over c -> a if c is to the right of the ray, else over
///      out  /  .   \.         b -> c.
///          a --|--> b
///              0
struct UnfoldedFace {
	int        halfEdge; ///< a -> b
	Vec3f      a, b, c;  ///< on the surface
	PlanePoint a2, b2, c2;
	Vec3f      cross; ///< of the face: two areas times the unit normal
	float      doubleArea;

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

		const float      u = dot(c - a, ab) / squared, v = doubleArea / squared;
		const PlanePoint ab2 = b2 - a2;
		c2                   = {a2.x + u * ab2.x - v * ab2.y, a2.y + u * ab2.y + v * ab2.x};
		return true;
	}
	bool apexIsLeftOf(RayDirection ray) const { return ray.cosine * c2.y > ray.sine * c2.x; }

	int exitOverBC() const { return nextInFace(halfEdge); }
	int exitOverCA() const { return prevInFace(halfEdge); }
	/// Makes this the neighbour over an edge, with an unknown apex; false at a border.
	bool crossBC(const HalfEdgeMesh& m)
	{
		a        = c;
		a2       = c2;
		halfEdge = m.opposite[exitOverBC()];
		return halfEdge >= 0;
	}
	bool crossCA(const HalfEdgeMesh& m)
	{
		b        = c;
		b2       = c2;
		halfEdge = m.opposite[exitOverCA()];
		return halfEdge >= 0;
	}
};

/// Place along the ray of its crossing with the edge p -> q, from right to left. At least `from`,
/// in spite of rounding.
inline float crossingOf(RayDirection ray, PlanePoint p, PlanePoint q, float from)
{
	const PlanePoint pq    = q - p;
	const float      slope = ray.cosine * pq.y - ray.sine * pq.x;
	const float      at    = slope > 0 ? cross(p, pq) / slope : from;
	return at > from ? at : from;
}

/// Follows a straight geodesic from the midpoint of half-edge h into its face and on. Calls
/// visit(exit, at) for each edge crossed within `reach`: exit is the half-edge of the face left by
/// the ray, at the length along the ray. Cost: the faces crossed, at most maxCrossings.
template <class Visit>
RayEnd traceRay(const HalfEdgeMesh& m, int h, RayDirection ray, float reach, int maxCrossings,
				const Visit& visit)
{
	UnfoldedFace f(m, h);
	float        at = 0;
	for (int crossings = 0; crossings < maxCrossings; ++crossings) {
		if (!f.unfoldApex(m)) return RayEnd::AtBorder;
		const bool overBC = f.apexIsLeftOf(ray);
		at = overBC ? crossingOf(ray, f.b2, f.c2, at) : crossingOf(ray, f.c2, f.a2, at);
		if (at >= reach) return RayEnd::Arrived;
		visit(overBC ? f.exitOverBC() : f.exitOverCA(), at);
		if (!(overBC ? f.crossBC(m) : f.crossCA(m))) return RayEnd::AtBorder;
	}
	return RayEnd::Capped;
}

} // namespace gpr

#endif
