// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_TRIANGLE_H
#define VCG_EXTRAS_CORE_BASE_TRIANGLE_H

#include <vcg_extras/core/vec.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gpr {

/// The corners of a triangle.
struct Corners {
	Vec3f a, b, c;

	/// The cross product of two edges: the unit normal times twice the area.
	Vec3f cross() const { return gpr::cross(b - a, c - a); }
};

/// Smallest angle of a triangle in radians; 0 if degenerate.
float smallestAngle(const Vec3f& a, const Vec3f& b, const Vec3f& c);

/// Largest angle of a triangle in radians.
float largestAngle(const Vec3f& a, const Vec3f& b, const Vec3f& c);

/// Shape of a triangle in [0, 1]: 4√3·area / (sum of squared edges); 1 = equilateral. Cost: a root.
float triangleShape(const Vec3f& a, const Vec3f& b, const Vec3f& c);

/// Whether the area of a triangle, in working units, is mere rounding; n is the cross product of
/// its edges.
inline bool isLine(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& n)
{
	constexpr float roundingHeight = 2e-7f; // height above the longest edge
	const float     longest =
		std::max({squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)});
	return !(squaredLength(n) > roundingHeight * roundingHeight * longest);
}

/// Whether a triangle has exactly no area, not even by rounding: no result may have such a face. n:
/// the cross product of its edges.
inline bool hasZeroArea(const Vec3f& n)
{
	return !(squaredLength(n) > 0);
}

/// The distance between the lines a-b and c-d; 0 if the lines are parallel.
template <class S>
S lineDistance(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c, const Vec3<S>& d)
{
	return std::abs(dot(normalized(cross(b - a, d - c)), c - a));
}

/// The point of the triangle a b c nearest to p.
Vec3f nearestOnTriangle(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c);

/// Weights of the corners a, b, c at the point q of their plane, with sum 1.
std::array<float, 3> weightsAt(const Vec3f& q, const Vec3f& a, const Vec3f& b, const Vec3f& c);

} // namespace gpr

#endif
