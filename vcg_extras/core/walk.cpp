// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "walk.h"

#include "face_tree.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Crossings in a row without getting on, as happens among slivers that meet in one vertex.
constexpr int mostIdleCrossings = 32;

/// A point of the plane that the faces on the way are unfolded into: the walk runs along +x from 0.
struct Flat {
	float x, y;
};

/// The edge by which the way leaves a face, from its end on the right of the way (y <= 0) to that
/// on the left (y > 0).
struct Exit {
	int  halfEdge;
	Flat right, left;

	/// Where the way crosses it.
	float x() const { return right.x + (left.x - right.x) * (right.y / (right.y - left.y)); }
};

/// Of the face that the walk begins in. Seen from inside, counter-clockwise corners have one edge
/// that goes from right to left; where rounding puts the start outside, the lowest corner counts as
/// right and the highest as left.
Exit exitOfFirstFace(const HalfEdgeMesh& m, const Anchor& at, const Vec3f& u, const Vec3f& w)
{
	Flat corner[3];
	int  lowest = 0, highest = 0;
	for (int k = 0; k < 3; ++k) {
		const Vec3f p = m.position[m.origin[3 * at.face + k]] - at.position;
		corner[k]     = {dot(p, u), dot(p, w)};
		if (corner[k].y < corner[lowest].y) lowest = k;
		if (corner[k].y > corner[highest].y) highest = k;
	}
	corner[lowest].y = std::min(corner[lowest].y, 0.0f);
	if (!(corner[highest].y > 0)) corner[highest].y = 1e-30f;
	int k = 0;
	while (k < 2 && !(corner[k].y <= 0 && corner[(k + 1) % 3].y > 0))
		++k;
	return {3 * at.face + k, corner[k], corner[(k + 1) % 3]};
}

/// The face beyond an exit, laid into the plane.
///
///            left
///           /  |                apex = right + edge·along + across·height,
///   apex  <    | <-- the way    where across is the edge turned by a right angle, ahead;
///           \  |                along and height are shares of the edge's length.
///            right
struct Unfolded {
	Vec3f start, edge, toApex; ///< in space: the right end, from there to the left end and the apex
	float along = 0, height = 0;
	Flat  apex{0, 0};

	/// False if the face has no area.
	bool set(const HalfEdgeMesh& m, const Exit& exit, int beyond)
	{
		start               = m.position[m.origin[exit.halfEdge]];
		edge                = m.position[m.target(exit.halfEdge)] - start;
		toApex              = m.position[m.apex(beyond)] - start;
		const float inverse = 1 / squaredLength(edge);
		along               = dot(toApex, edge) * inverse;
		const float squared = squaredLength(toApex) * inverse - along * along;
		if (!(squared > 0 && squared < HUGE_VALF)) return false;
		height        = std::sqrt(squared);
		const float x = exit.left.x - exit.right.x;
		const float y = exit.left.y - exit.right.y;
		apex.x        = exit.right.x + x * along + y * height;
		apex.y        = exit.right.y + y * along - x * height;
		return true;
	}

	/// The place in space of the point (x, 0).
	Vec3f placeOf(const Exit& exit, float x) const
	{
		const float ex = exit.left.x - exit.right.x, ey = exit.left.y - exit.right.y;
		const float inverse = 1 / (ex * ex + ey * ey);
		const float px = x - exit.right.x, py = -exit.right.y;
		const float s = (px * ex + py * ey) * inverse, t = (px * ey - py * ex) * inverse;
		const float share = std::clamp(t / height, 0.0f, 1.0f);
		return start + edge * s + (toApex - edge * along) * share;
	}
};

/// The place in space where the way meets the exit.
Vec3f placeOn(const HalfEdgeMesh& m, const Exit& exit)
{
	const Vec3f a = m.position[m.origin[exit.halfEdge]], b = m.position[m.target(exit.halfEdge)];
	return a + (b - a) * (exit.right.y / (exit.right.y - exit.left.y));
}

/// How much the normal of the face that a walk begins in is to be trusted, by the sine of the angle
/// at its first corner: rounding turns the normal by some 1e-7 over the sine.
struct StartFace {
	Vec3f a, b, c;
	Vec3f cross;       ///< two areas times the unit normal
	float squaredSine; ///< 0 where two corners coincide

	StartFace(const HalfEdgeMesh& m, int f) :
			a(m.position[m.origin[3 * f]]), b(m.position[m.origin[3 * f + 1]]),
			c(m.position[m.origin[3 * f + 2]])
	{
		const float edges = squaredLength(b - a) * squaredLength(c - a);
		cross             = gpr::cross(b - a, c - a);
		squaredSine       = edges > 0 ? squaredLength(cross) / edges : 0;
	}
	bool hasArea() const { return squaredSine > 1e-10f; }

	/// Takes rounding away, which in the plane of a needle is much.
	Vec3f putBack(const Vec3f& p, const Vec3f& normal) const
	{
		constexpr float needle = 1e-6f;
		if (squaredSine < needle) return nearestOnTriangle(p, a, b, c);
		return p - normal * dot(p - a, normal);
	}
};

} // namespace

/// No face's normal is needed on the way, and one root a face: see Unfolded.
WalkEnd walk(const HalfEdgeMesh& m, Anchor& at, const Vec3f& step, int mostCrossings)
{
	const float wanted = length(step);
	if (!(wanted > 0)) return WalkEnd::Arrived;
	const StartFace start(m, at.face);
	if (!start.hasArea()) return WalkEnd::AtBorder;
	const Vec3f normal = normalized(start.cross);
	const Vec3f ahead  = tangential(step, normal);
	const float flat   = length(ahead);
	if (!(flat > 0)) return WalkEnd::Arrived;
	const Vec3f u    = ahead * (1 / flat);
	Exit        exit = exitOfFirstFace(m, at, u, cross(normal, u));
	float       x    = exit.x();
	if (x >= wanted) {
		at.position = start.putBack(at.position + u * wanted, normal);
		return WalkEnd::Arrived;
	}

	Unfolded face;
	int      idle = 0;
	for (int crossed = 0; crossed < mostCrossings && idle <= mostIdleCrossings; ++crossed) {
		const int beyond = m.opposite[exit.halfEdge];
		if (beyond < 0 || !face.set(m, exit, beyond)) {
			at = {placeOn(m, exit), exit.halfEdge / 3};
			return WalkEnd::AtBorder;
		}
		// `beyond` runs from the left end to the right one, the next edge from there to the apex.
		const Exit  next    = face.apex.y > 0 ? Exit{nextInFace(beyond), exit.right, face.apex}
											  : Exit{prevInFace(beyond), face.apex, exit.left};
		const float reached = next.x();
		if (reached >= wanted) {
			at = {face.placeOf(exit, wanted), beyond / 3};
			return WalkEnd::Arrived;
		}
		idle = reached > x + 1e-6f * wanted ? 0 : idle + 1;
		x    = reached;
		exit = next;
	}
	at = {placeOn(m, exit), exit.halfEdge / 3};
	return WalkEnd::Capped;
}

std::vector<int> facesAt(const HalfEdgeMesh& m, const Anchor& at)
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
