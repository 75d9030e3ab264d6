// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_SYMMETRIC_MATRIX_H
#define VCG_EXTRAS_CORE_BASE_SYMMETRIC_MATRIX_H

#include <vcg_extras/core/vec.h>

namespace gpr {

/// Symmetric 3×3 matrix, such as a sum of w·n·nᵀ.
struct SymmetricMatrix {
	float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

	SymmetricMatrix& operator+=(const SymmetricMatrix& o)
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
	void addOuter(const Vec3f& n, float w)
	{
		const Vec3f wn = n * w;
		xx += wn.x * n.x;
		xy += wn.x * n.y;
		xz += wn.x * n.z;
		yy += wn.y * n.y;
		yz += wn.y * n.z;
		zz += wn.z * n.z;
	}
	/// Adds w times the identity.
	void addDiagonal(float w)
	{
		xx += w;
		yy += w;
		zz += w;
	}

	Vec3f operator*(const Vec3f& v) const
	{
		return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z,
				xz * v.x + yz * v.y + zz * v.z};
	}

	/// x with this · x = b, by cofactors in double; zero where the matrix is singular.
	Vec3f solve(const Vec3f& b) const
	{
		const double a = xx, c = xy, d = xz, e = yy, f = yz, g = zz;
		const double A = e * g - f * f, B = d * f - c * g, C = c * f - d * e;
		const double determinant = a * A + c * B + d * C;
		if (!(std::abs(determinant) > 0)) return {};
		const double i = 1 / determinant;
		return {float(i * (A * b.x + B * b.y + C * b.z)),
				float(i * (B * b.x + (a * g - d * d) * b.y + (c * d - a * f) * b.z)),
				float(i * (C * b.x + (c * d - a * f) * b.y + (a * e - c * c) * b.z))};
	}
};

} // namespace gpr

#endif
