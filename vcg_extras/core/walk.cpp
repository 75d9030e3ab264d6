// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "walk.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Crossings in a row without getting on, as happens among slivers that meet in one vertex.
constexpr int mostIdleCrossings = 32;

/// Where the ray p + t·d leaves the face, for t in [0, 1]: the half-edge, or -1 if it stays inside.
int exitEdge(const HalfEdgeMesh& m, int face, const Vec3f& normal, const Vec3f& p, const Vec3f& d,
			 int enteredBy, float& t)
{
	int exit = -1;
	t        = 1;
	for (int h = 3 * face; h < 3 * face + 3; ++h) {
		if (h == enteredBy) continue;
		const Vec3f a       = m.position[m.origin[h]];
		const Vec3f inward  = cross(normal, m.position[m.target(h)] - a);
		const float speed   = dot(d, inward);
		const float distant = dot(p - a, inward);
		if (speed >= 0) continue;
		const float at = distant > 0 ? -distant / speed : 0.0f;
		if (at < t) {
			t    = at;
			exit = h;
		}
	}
	return exit;
}

/// Takes rounding away: back into the plane of the face.
void settle(const HalfEdgeMesh& m, Anchor& at, const Vec3f& normal)
{
	const Vec3f a = m.position[m.origin[3 * at.face]];
	at.position   = at.position - normal * dot(at.position - a, normal);
}

} // namespace

WalkEnd walk(const HalfEdgeMesh& m, Anchor& at, const Vec3f& step, int mostCrossings)
{
	const float wanted = length(step);
	if (!(wanted > 0)) return WalkEnd::Arrived;
	Vec3f       normal = m.faceNormal(at.face);
	Vec3f       d      = tangential(step, normal);
	const float flat   = length(d);
	if (!(flat > 0)) return WalkEnd::Arrived;
	d = d * (wanted / flat);

	int enteredBy = -1;
	int idle      = 0;
	for (int crossed = 0; crossed < mostCrossings; ++crossed) {
		float     t    = 1;
		const int exit = exitEdge(m, at.face, normal, at.position, d, enteredBy, t);
		at.position    = at.position + d * t;
		if (exit < 0) {
			settle(m, at, normal);
			return WalkEnd::Arrived;
		}
		idle = t > 1e-6f ? 0 : idle + 1;
		if (idle > mostIdleCrossings) return WalkEnd::Capped;
		const int beyond = m.opposite[exit];
		if (beyond < 0) return WalkEnd::AtBorder;
		const Vec3f nextNormal = m.faceNormal(beyond / 3);
		if (!(squaredLength(nextNormal) > 0)) return WalkEnd::AtBorder;

		// Unfold: the part along the edge stays, the part across turns into the next face's plane.
		const Vec3f along  = normalized(m.position[m.target(exit)] - m.position[m.origin[exit]]);
		d                  = d * (1 - t);
		const float across = std::max(0.0f, dot(d, cross(along, normal)));
		d                  = along * dot(d, along) + cross(along, nextNormal) * across;
		normal             = nextNormal;
		at.face            = beyond / 3;
		enteredBy          = beyond;
	}
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
