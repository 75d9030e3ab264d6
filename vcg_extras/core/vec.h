// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_VEC_H
#define VCG_EXTRAS_CORE_VEC_H

#include <algorithm>
#include <cmath>

namespace gpr {

inline constexpr double pi      = 3.14159265358979323846;
inline constexpr float  radians = float(pi) / 180; ///< radians of a degree

/// A 3-vector; S is float for stored coordinates, double for decisions that need double.
template <class S>
struct Vec3 {
	S x = 0, y = 0, z = 0;

	Vec3() = default;
	Vec3(S x_, S y_, S z_) : x(x_), y(y_), z(z_) {}
	template <class T>
	explicit Vec3(const Vec3<T>& v) : x(S(v.x)), y(S(v.y)), z(S(v.z))
	{
	}

	Vec3& operator+=(const Vec3& b)
	{
		x += b.x;
		y += b.y;
		z += b.z;
		return *this;
	}
};

/// A point or a vector of a plane.
template <class S>
struct Vec2 {
	S x = 0, y = 0;
};

/// x, y or z, by number from 0.
template <class S>
inline S coordinate(const Vec3<S>& v, int axis)
{
	return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

template <class S>
inline void setCoordinate(Vec3<S>& v, int axis, S value)
{
	(axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value;
}

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;
using Vec2f = Vec2<float>;
using Vec2d = Vec2<double>;

template <class S>
inline Vec3<S> operator+(const Vec3<S>& a, const Vec3<S>& b)
{
	return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class S>
inline Vec3<S> operator-(const Vec3<S>& a, const Vec3<S>& b)
{
	return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S>
inline Vec3<S> operator*(const Vec3<S>& a, S s)
{
	return {a.x * s, a.y * s, a.z * s};
}
template <class S>
inline bool operator==(const Vec3<S>& a, const Vec3<S>& b)
{
	return a.x == b.x && a.y == b.y && a.z == b.z;
}
template <class S>
inline S dot(const Vec3<S>& a, const Vec3<S>& b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S>
inline Vec3<S> cross(const Vec3<S>& a, const Vec3<S>& b)
{
	return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class S>
inline S squaredLength(const Vec3<S>& a)
{
	return dot(a, a);
}
template <class S>
inline S length(const Vec3<S>& a)
{
	return std::sqrt(dot(a, a));
}
template <class S>
inline bool isFinite(const Vec3<S>& a)
{
	return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
/// a / |a|; the zero vector stays zero.
template <class S>
inline Vec3<S> normalized(const Vec3<S>& a)
{
	const S l = length(a);
	return l > S(0) ? a * (S(1) / l) : a;
}
/// The component of a perpendicular to the unit vector n.
template <class S>
inline Vec3<S> tangential(const Vec3<S>& a, const Vec3<S>& n)
{
	return a - n * dot(n, a);
}

template <class S>
inline Vec2<S> operator-(const Vec2<S>& a, const Vec2<S>& b)
{
	return {a.x - b.x, a.y - b.y};
}
template <class S>
inline S dot(const Vec2<S>& a, const Vec2<S>& b)
{
	return a.x * b.x + a.y * b.y;
}
template <class S>
inline S cross(const Vec2<S>& a, const Vec2<S>& b)
{
	return a.x * b.y - a.y * b.x;
}

/// Share of the way from a to b of the point nearest to p; 0 if a and b coincide.
template <class S>
inline S shareOnSegment(const Vec3<S>& p, const Vec3<S>& a, const Vec3<S>& b)
{
	const Vec3<S> ab      = b - a;
	const S       squared = squaredLength(ab);
	return squared > S(0) ? std::min(S(1), std::max(S(0), dot(p - a, ab) / squared)) : S(0);
}

} // namespace gpr

#endif
