// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "orientation.h"

#include <cmath>
#include <cstddef>

namespace gpr {

namespace {

int signOf(double x)
{
	return (x > 0) - (x < 0);
}

/// A rounded sum of two doubles and the rounding error: Knuth's two-sum.
struct ExactPair {
	double high, low;
};

ExactPair exactSum(double a, double b)
{
	const double sum = a + b, ofB = sum - a, ofA = sum - ofB;
	return {sum, (a - ofA) + (b - ofB)};
}

/// The upper 26 bits of a double (Veltkamp).
double upperHalf(double a)
{
	constexpr double splitter = 134217729; // 2^27 + 1
	const double     c        = splitter * a;
	return c - (c - a);
}

/// A rounded product of two doubles and the rounding error: Dekker's product.
ExactPair exactProduct(double a, double b)
{
	const double product = a * b;
	const double ah = upperHalf(a), al = a - ah, bh = upperHalf(b), bl = b - bh;
	return {product, al * bl - (((product - ah * bh) - al * bh) - ah * bl)};
}

/// The sign of a sum, exactly: -1, 0 or 1. Needs finite terms, at most 64, without overflow of any
/// partial sum. Expansions after Shewchuk (1997, Adaptive Precision Floating-Point Arithmetic and
/// Fast Robust Geometric Predicates). Cost: O(num²).
int signOfSum(const double* term, std::size_t num)
{
	constexpr std::size_t most = 64;
	double                part[most]; // no two overlap, the largest is the last
	std::size_t           partNum = 0;
	for (std::size_t i = 0; i < num; ++i) {
		double      carried = term[i];
		std::size_t kept    = 0;
		for (std::size_t k = 0; k < partNum; ++k) {
			const ExactPair s = exactSum(carried, part[k]);
			if (s.low != 0) part[kept++] = s.low;
			carried = s.high;
		}
		if (carried != 0) part[kept++] = carried;
		partNum = kept;
	}
	return partNum == 0 ? 0 : signOf(part[partNum - 1]);
}

/// Terms of an exact sum.
struct Terms {
	double      term[48]; ///< of four determinants at most
	std::size_t num = 0;

	void add(double x)
	{
		if (x != 0) term[num++] = x;
	}
	/// Adds ab·c. ab must be exact: a product of two floats.
	void addProduct(double ab, double c)
	{
		const ExactPair p = exactProduct(ab, c);
		add(p.low);
		add(p.high);
	}
	/// Adds the determinant of three rows, times a sign.
	void addDeterminant(const Vec3d& a, const Vec3d& b, const Vec3d& c, double sign)
	{
		addProduct(sign * a.x * b.y, c.z);
		addProduct(sign * a.y * b.z, c.x);
		addProduct(sign * a.z * b.x, c.y);
		addProduct(-sign * a.z * b.y, c.x);
		addProduct(-sign * a.y * b.x, c.z);
		addProduct(-sign * a.x * b.z, c.y);
	}
	int sign() const { return signOfSum(term, num); }
};

/// The orientation of any float points, without differences.
int exactOrientation(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d)
{
	Terms t;
	t.addDeterminant(b, c, d, 1);
	t.addDeterminant(a, c, d, -1);
	t.addDeterminant(a, b, d, 1);
	t.addDeterminant(a, b, c, -1);
	return t.sign();
}

} // namespace

int orientation(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d)
{
	const Vec3d  o(a), u = Vec3d(b) - o, v = Vec3d(c) - o, w = Vec3d(d) - o;
	const double xy = u.x * v.y, yx = u.y * v.x, yz = u.y * v.z, zy = u.z * v.y;
	const double zx = u.z * v.x, xz = u.x * v.z;
	const double volume    = (xy - yx) * w.z + (yz - zy) * w.x + (zx - xz) * w.y;
	const double magnitude = (std::abs(xy) + std::abs(yx)) * std::abs(w.z) +
							 (std::abs(yz) + std::abs(zy)) * std::abs(w.x) +
							 (std::abs(zx) + std::abs(xz)) * std::abs(w.y);
	constexpr double rounding = 1e-15; // (7 + 56ε) ε with Shewchuk's ε = 2^-53, and more
	if (std::abs(volume) > rounding * magnitude) return signOf(volume);
	if (magnitude == 0) return 0;
	return exactOrientation(o, Vec3d(b), Vec3d(c), Vec3d(d));
}

int orientation(const Vec2f& a, const Vec2f& b, const Vec2f& c)
{
	// A product of two floats is exact in a double.
	const double   ax = a.x, ay = a.y, bx = b.x, by = b.y, cx = c.x, cy = c.y;
	const double   left = (bx - ax) * (cy - ay), right = (by - ay) * (cx - ax);
	const double   area     = left - right;
	constexpr auto rounding = 1e-15;
	if (std::abs(area) > rounding * (std::abs(left) + std::abs(right))) return signOf(area);
	const double term[] = {ax * by, -ay * bx, bx * cy, -by * cx, cx * ay, -cy * ax};
	return signOfSum(term, 6);
}

} // namespace gpr
