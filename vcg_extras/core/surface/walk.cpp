// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "walk.h"

#include "local_nearest.h"

#include <vcg_extras/core/base/triangle.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Crossings in a row without advance, as among needles at the same vertex.
constexpr int maxIdleCrossings = 32;

/// A corner in the plane of the unfolded faces, in which the walk runs along +x from 0, and in
/// space; the position in space is read once only.
struct Corner {
	Vec2f flat;
	Vec3f place;
};

/// The edge by which the walk leaves a face, from its end on the right of the walk (y <= 0) to its
/// end on the left (y > 0).
struct Exit {
	int    halfEdge;
	Corner right, left;

	/// Share of the way from right to left at which the walk crosses the edge.
	float share() const { return right.flat.y / (right.flat.y - left.flat.y); }
	/// The place of the crossing along the walk.
	float x() const { return right.flat.x + (left.flat.x - right.flat.x) * share(); }
	/// The same place in space.
	Vec3f place() const { return right.place + (left.place - right.place) * share(); }
};

/// Exit of the first face of a walk. Seen from inside, one edge of the counter-clockwise corners
/// goes from right to left. If rounding puts the start outside, the lowest corner counts as right
/// and the highest as left.
Exit exitOfFirstFace(const HalfEdgeMesh& m, const SurfacePoint& at, const Vec3f& u, const Vec3f& w)
{
	Corner corner[3];
	int    lowest = 0, highest = 0;
	for (int k = 0; k < 3; ++k) {
		const Vec3f place = m.position[m.origin[3 * at.face + k]];
		const Vec3f p     = place - at.position;
		corner[k]         = {{dot(p, u), dot(p, w)}, place};
		if (corner[k].flat.y < corner[lowest].flat.y) lowest = k;
		if (corner[k].flat.y > corner[highest].flat.y) highest = k;
	}
	corner[lowest].flat.y = std::min(corner[lowest].flat.y, 0.0f);
	if (!(corner[highest].flat.y > 0)) corner[highest].flat.y = 1e-30f;
	int k = 0;
	while (k < 2 && !(corner[k].flat.y <= 0 && corner[(k + 1) % 3].flat.y > 0))
		++k;
	return {3 * at.face + k, corner[k], corner[(k + 1) % 3]};
}

/// The face beyond an exit, laid into the plane.
///
///            left
///           /  |                apex = right + edge·along + across·height;
///   apex  <    | <-- the walk   across is the edge turned by a right angle, ahead;
///           \  |                along and height are shares of the edge's length.
///            right
struct Unfolded {
	Vec3f  edge, toApex; ///< in space, from the right end to the left one and the apex
	float  along = 0, height = 0;
	Corner apex{{0, 0}, {}};

	/// False if the face has no area.
	bool set(const HalfEdgeMesh& m, const Exit& exit, int beyond)
	{
		apex.place          = m.position[m.apex(beyond)];
		edge                = exit.left.place - exit.right.place;
		toApex              = apex.place - exit.right.place;
		const float inverse = 1 / squaredLength(edge);
		along               = dot(toApex, edge) * inverse;
		const float squared = squaredLength(toApex) * inverse - along * along;
		if (!(squared > 0 && squared < HUGE_VALF)) return false;
		height           = std::sqrt(squared);
		const Vec2f from = exit.right.flat, e = exit.left.flat - from;
		apex.flat = {from.x + e.x * along + e.y * height, from.y + e.y * along - e.x * height};
		return true;
	}

	/// The place in space of the point (x, 0).
	Vec3f placeOf(const Exit& exit, float x) const
	{
		const Vec2f from = exit.right.flat, e = exit.left.flat - from;
		const Vec2f p       = {x - from.x, -from.y};
		const float inverse = 1 / dot(e, e);
		const float s = dot(p, e) * inverse, t = cross(p, e) * inverse;
		const float share = std::clamp(t / height, 0.0f, 1.0f);
		return exit.right.place + edge * s + (toApex - edge * along) * share;
	}
};

/// The corners of the first face of a walk, and the trust in its normal: the squared sine of the
/// angle at its first corner is `squaredArea` over `edges`. Rounding turns the normal by some 1e-7
/// over the sine.
struct StartFace {
	Vec3f a, b, c;
	Vec3f cross;       ///< two areas times the unit normal
	float squaredArea; ///< four times the square of the area
	float edges;       ///< product of the squared edges at the corner; 0 where two corners coincide

	StartFace(const HalfEdgeMesh& m, int f) :
			a(m.position[m.origin[3 * f]]), b(m.position[m.origin[3 * f + 1]]),
			c(m.position[m.origin[3 * f + 2]]), cross(gpr::cross(b - a, c - a)),
			squaredArea(squaredLength(cross)), edges(squaredLength(b - a) * squaredLength(c - a))
	{
	}
	bool hasArea() const { return squaredArea > 1e-10f * edges; }

	/// Removes the rounding of p, which is large in the plane of a needle.
	Vec3f putBack(const Vec3f& p, const Vec3f& normal) const
	{
		constexpr float needle = 1e-6f; // an angle of a thousandth: rounding moves points as far
		if (squaredArea < needle * edges) return nearestOnTriangle(p, a, b, c);
		return p - normal * dot(p - a, normal);
	}
};

/// A walk of the length `wanted` along the unit vector u in the first face, with the given unit
/// normal. The way needs no other normals, and one root per face: see Unfolded. As walk().
bool walkAlong(const HalfEdgeMesh& m, SurfacePoint& at, const StartFace& start, const Vec3f& normal,
			   const Vec3f& u, float wanted, int maxCrossings)
{
	Exit  exit = exitOfFirstFace(m, at, u, cross(normal, u));
	float x    = exit.x();
	if (x >= wanted) {
		at.position = start.putBack(at.position + u * wanted, normal);
		return true;
	}

	Unfolded face;
	int      idle = 0;
	for (int crossed = 0; crossed < maxCrossings && idle <= maxIdleCrossings; ++crossed) {
		const int beyond = m.opposite[exit.halfEdge];
		if (beyond < 0 || !face.set(m, exit, beyond)) {
			at = {exit.place(), exit.halfEdge / 3};
			return false;
		}
		// `beyond` runs from the left end to the right end, the next edge from there to the apex.
		const Exit  next    = face.apex.flat.y > 0 ? Exit{nextInFace(beyond), exit.right, face.apex}
												   : Exit{prevInFace(beyond), face.apex, exit.left};
		const float reached = next.x();
		if (reached >= wanted) {
			at = {face.placeOf(exit, wanted), beyond / 3};
			return true;
		}
		idle = reached > x + 1e-6f * wanted ? 0 : idle + 1;
		x    = reached;
		exit = next;
	}
	at = {exit.place(), exit.halfEdge / 3};
	return false;
}

} // namespace

bool walk(const HalfEdgeMesh& m, SurfacePoint& at, const Vec3f& step, int maxCrossings)
{
	const float wanted = length(step);
	if (!(wanted > 0)) return true;
	const StartFace start(m, at.face);
	if (!start.hasArea()) return false;
	const Vec3f normal = normalized(start.cross);
	const Vec3f ahead  = tangential(step, normal);
	const float flat   = length(ahead);
	if (!(flat > 0)) return true;
	return walkAlong(m, at, start, normal, ahead * (1 / flat), wanted, maxCrossings);
}

/// Saves most of the roots and divisions of a walk, which a normal of the first face would take: a
/// record knows its normal, and keeps the normal if the face stays.
bool walkBy(const Surface& surface, const Vec3f& step, ResultVertex& vertex)
{
	const HalfEdgeMesh& m      = surface.mesh;
	const float         wanted = length(step);
	if (!(wanted > 0)) return true;
	const int       face = vertex.point.face;
	const StartFace start(m, face);
	if (!start.hasArea()) return false;
	const bool hasArrived = walkAlong(m, vertex.point, start, vertex.normal, step * (1 / wanted),
									  wanted, maxFacesCrossed);
	if (vertex.point.face != face) vertex.normal = m.faceNormal(vertex.point.face);
	return hasArrived;
}

void followOnSurface(const Surface& surface, int v, ResultMesh& r)
{
	const HalfEdgeMesh& m      = surface.mesh;
	const Vec3f         place  = r.mesh.position[v];
	ResultVertex&       record = r.vertex[v];
	const int           from   = m.origin[3 * record.point.face];
	const Vec3f         step   = place - record.point.position;
	walkBy(surface, tangential(step, record.normal), record);
	// Round a crease edge a walk leads away, and each further walk would lead farther away.
	if (squaredLength(place - record.point.position) <= squaredLength(step)) return;
	record.point  = nearestByDescent(m, from, place);
	record.normal = m.faceNormal(record.point.face);
}

std::vector<int> facesAt(const HalfEdgeMesh& m, const SurfacePoint& at)
{
	constexpr float  rounding = 1e-4f; // of the edge
	std::vector<int> faces    = {at.face};
	for (int h = 3 * at.face; h < 3 * at.face + 3; ++h) {
		const Vec3f a = m.position[m.origin[h]], ab = m.position[m.target(h)] - a;
		const float close = rounding * length(ab);
		if (length(at.position - a) <= close) {
			faces.clear();
			forEachOutgoing(m, m.origin[h], [&](int x) { faces.push_back(x / 3); });
			return faces;
		}
		const bool onEdge = length(cross(at.position - a, ab)) <= close * length(ab);
		if (onEdge && m.opposite[h] >= 0) faces.push_back(m.opposite[h] / 3);
	}
	return faces;
}

std::array<Vec3f, 8> compassDirections(const Vec3f& normal)
{
	constexpr float diagonal = 0.70710678f;
	const Vec3f     away     = std::abs(normal.x) < 0.8f ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0);
	const Vec3f     u        = normalized(cross(normal, away));
	const Vec3f     w        = cross(normal, u);
	const Vec3f     v        = (u + w) * diagonal;
	const Vec3f     x        = (w - u) * diagonal;
	return {u, v, w, x, u * -1.0f, v * -1.0f, w * -1.0f, x * -1.0f};
}

} // namespace gpr
