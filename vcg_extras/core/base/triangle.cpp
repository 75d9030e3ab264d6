// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle.h"

#include "angle.h"

namespace gpr {

namespace {

Vec3f nearestOnSegment(const Vec3f& p, const Vec3f& a, const Vec3f& b)
{
	return a + (b - a) * shareOnSegment(p, a, b);
}

/// The nearest point for degenerate triangles, whose inside is undefined.
Vec3f nearestOnOutline(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	Vec3f best = nearestOnSegment(p, a, b);
	for (const Vec3f& q : {nearestOnSegment(p, b, c), nearestOnSegment(p, c, a)}) {
		if (squaredLength(p - q) < squaredLength(p - best)) best = q;
	}
	return best;
}

/// False if the sine of the angle at a is lost in rounding.
bool hasArea(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	const Vec3f ab = b - a, ac = c - a;
	const float sine = squaredLength(cross(ab, ac));
	return sine > 1e-10f * squaredLength(ab) * squaredLength(ac);
}

} // namespace

float smallestAngle(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	// The smallest angle lies opposite the shortest edge.
	const float ab = squaredLength(b - a), bc = squaredLength(c - b), ca = squaredLength(a - c);
	if (ab <= bc && ab <= ca) return angleBetween(a - c, b - c);
	if (bc <= ca) return angleBetween(b - a, c - a);
	return angleBetween(a - b, c - b);
}

float largestAngle(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	// The largest angle lies opposite the longest edge.
	const float ab = squaredLength(b - a), bc = squaredLength(c - b), ca = squaredLength(a - c);
	if (ab >= bc && ab >= ca) return angleBetween(a - c, b - c);
	if (bc >= ca) return angleBetween(b - a, c - a);
	return angleBetween(a - b, c - b);
}

float triangleShape(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	const float edges = squaredLength(b - a) + squaredLength(c - b) + squaredLength(a - c);
	return 3.4641016f * length(cross(b - a, c - a)) / (edges + 1e-30f);
}

/// Finds the region of the triangle in which p lies (Ericson, Real-Time Collision Detection,
/// §5.1.5).
Vec3f nearestOnTriangle(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	const Vec3f ab = b - a, ac = c - a, ap = p - a;
	const float d1 = dot(ab, ap), d2 = dot(ac, ap);
	if (d1 <= 0 && d2 <= 0) return a;
	const Vec3f bp = p - b;
	const float d3 = dot(ab, bp), d4 = dot(ac, bp);
	if (d3 >= 0 && d4 <= d3) return b;
	if (!hasArea(a, b, c)) return nearestOnOutline(p, a, b, c);
	const float vc = d1 * d4 - d3 * d2;
	if (vc <= 0 && d1 >= 0 && d3 <= 0) return d1 > d3 ? a + ab * (d1 / (d1 - d3)) : a;
	const Vec3f cp = p - c;
	const float d5 = dot(ab, cp), d6 = dot(ac, cp);
	if (d6 >= 0 && d5 <= d6) return c;
	const float vb = d5 * d2 - d1 * d6;
	if (vb <= 0 && d2 >= 0 && d6 <= 0) return d2 > d6 ? a + ac * (d2 / (d2 - d6)) : a;
	const float va = d3 * d6 - d5 * d4;
	if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
		const float sum = (d4 - d3) + (d5 - d6);
		return sum > 0 ? b + (c - b) * ((d4 - d3) / sum) : b;
	}
	const float scale = 1 / (va + vb + vc);
	return a + ab * (vb * scale) + ac * (vc * scale);
}

std::array<float, 3> weightsAt(const Vec3f& q, const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	const Vec3f n       = cross(b - a, c - a);
	const float squared = squaredLength(n) + 1e-30f; // not zero for degenerate triangles
	const float atB     = dot(cross(q - a, c - a), n) / squared;
	const float atC     = dot(cross(b - a, q - a), n) / squared;
	return {1 - atB - atC, atB, atC};
}

} // namespace gpr
