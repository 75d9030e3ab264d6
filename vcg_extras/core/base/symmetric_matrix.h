// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_SYMMETRIC_MATRIX_H
#define VCG_EXTRAS_CORE_BASE_SYMMETRIC_MATRIX_H

#include "float4.h"

#include <cmath>
#include <optional>

namespace gpr {

/// Symmetric 3×3 matrix, such as a sum of w·n·nᵀ.
template <class Scalar>
struct SymmetricMatrixOf {
	Scalar xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

	SymmetricMatrixOf& operator+=(const SymmetricMatrixOf& o)
	{
		xx += o.xx;
		xy += o.xy;
		xz += o.xz;
		yy += o.yy;
		yz += o.yz;
		zz += o.zz;
		return *this;
	}
	/// Adds w·n·nᵀ.
	void addOuter(const Vec3<Scalar>& n, Scalar w)
	{
		const Vec3<Scalar> wn = n * w;
		xx += wn.x * n.x;
		xy += wn.x * n.y;
		xz += wn.x * n.z;
		yy += wn.y * n.y;
		yz += wn.y * n.z;
		zz += wn.z * n.z;
	}
	/// Adds w times the identity.
	void addDiagonal(Scalar w)
	{
		xx += w;
		yy += w;
		zz += w;
	}

	Scalar trace() const { return xx + yy + zz; }

	Vec3<Scalar> operator*(const Vec3<Scalar>& v) const
	{
		return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z,
				xz * v.x + yz * v.y + zz * v.z};
	}

	/// Solves this · x = b, by cofactors in double; nothing if |determinant| is at most `smallest`.
	std::optional<Vec3<Scalar>> solve(const Vec3<Scalar>& b, double smallest = 0) const
	{
		const double a = xx, c = xy, d = xz, e = yy, f = yz, g = zz;
		const double A = e * g - f * f, B = d * f - c * g, C = c * f - d * e;
		const double determinant = a * A + c * B + d * C;
		if (!(std::abs(determinant) > smallest)) return std::nullopt;
		const double i = 1 / determinant;
		const double D = a * g - d * d, E = c * d - a * f, F = a * e - c * c;
		return Vec3<Scalar>(Scalar(i * (A * b.x + B * b.y + C * b.z)),
							Scalar(i * (B * b.x + D * b.y + E * b.z)),
							Scalar(i * (C * b.x + E * b.y + F * b.z)));
	}
};

using SymmetricMatrix = SymmetricMatrixOf<float>;

/// The same in two vectors, for many sums and products: xx xy xz yy and yz zz.
struct SymmetricLanes {
	Float4 first, last;

	/// n·nᵀ
	static SymmetricLanes outer(const Vec3f& n)
	{
		return {{n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y}, {n.y * n.z, n.z * n.z, 0, 0}};
	}

	SymmetricMatrix matrix() const
	{
		return {first[0], first[1], first[2], first[3], last[0], last[1]};
	}

	SymmetricLanes& operator+=(const SymmetricLanes& o)
	{
		first += o.first;
		last += o.last;
		return *this;
	}
	SymmetricLanes operator*(float w) const { return {first * w, last * w}; }
	/// The product with a 3-vector; the fourth lane has no meaning.
	Float4 operator*(const Float4& v) const
	{
		const Float4 second(first[1], first[3], last[0], last[1]);
		const Float4 third(first[2], last[0], last[1], last[1]);
		return first * v[0] + second * v[1] + third * v[2];
	}
};

} // namespace gpr

#endif
