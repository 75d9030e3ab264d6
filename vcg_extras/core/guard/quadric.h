// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_QUADRIC_H
#define VCG_EXTRAS_CORE_GUARD_QUADRIC_H

#include <vcg_extras/core/vec.h>

#include <cmath>

namespace gpr {

/// Weighted sum of squared distances from planes (Garland and Heckbert 1997, Surface Simplification
/// Using Quadric Error Metrics): xᵀAx - 2bᵀx + c.
struct Quadric {
	double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
	Vec3d  b;
	double c = 0;

	Quadric& operator+=(const Quadric& o)
	{
		xx += o.xx;
		xy += o.xy;
		xz += o.xz;
		yy += o.yy;
		yz += o.yz;
		zz += o.zz;
		b += o.b;
		c += o.c;
		return *this;
	}

	/// The plane through p with unit normal n.
	void addPlane(const Vec3d& p, const Vec3d& n, double weight)
	{
		const double d = dot(n, p), wx = weight * n.x, wy = weight * n.y, wz = weight * n.z;
		xx += wx * n.x;
		xy += wx * n.y;
		xz += wx * n.z;
		yy += wy * n.y;
		yz += wy * n.z;
		zz += wz * n.z;
		b += n * (weight * d);
		c += weight * d * d;
	}

	/// Adds weight·|x - p|².
	void addPoint(const Vec3d& p, double weight)
	{
		xx += weight;
		yy += weight;
		zz += weight;
		b += p * weight;
		c += weight * dot(p, p);
	}

	double trace() const { return xx + yy + zz; }

	/// Never negative, though rounding may be.
	double at(const Vec3d& p) const
	{
		const Vec3d  ap{xx * p.x + xy * p.y + xz * p.z, xy * p.x + yy * p.y + yz * p.z,
                       xz * p.x + yz * p.y + zz * p.z};
		const double value = dot(p, ap) - 2 * dot(b, p) + c;
		return value > 0 ? value : 0;
	}

	/// Where it is smallest; `otherwise` where that is not one point.
	Vec3d lowest(const Vec3d& otherwise) const
	{
		const double A = yy * zz - yz * yz, B = xz * yz - xy * zz, C = xy * yz - xz * yy;
		const double determinant = xx * A + xy * B + xz * C;
		const double size        = trace();
		if (!(std::abs(determinant) > 1e-12 * size * size * size)) return otherwise;
		const double i = 1 / determinant;
		const double D = xx * zz - xz * xz, E = xz * xy - xx * yz, F = xx * yy - xy * xy;
		return {i * (A * b.x + B * b.y + C * b.z), i * (B * b.x + D * b.y + E * b.z),
				i * (C * b.x + E * b.y + F * b.z)};
	}
};

} // namespace gpr

#endif
