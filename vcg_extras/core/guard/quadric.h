// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_QUADRIC_H
#define VCG_EXTRAS_CORE_GUARD_QUADRIC_H

#include <vcg_extras/core/base/symmetric_matrix.h>

namespace gpr {

/// Weighted sum of squared distances from planes (Garland and Heckbert 1997, Surface Simplification
/// Using Quadric Error Metrics): xᵀAx - 2bᵀx + c.
struct Quadric {
	SymmetricMatrixOf<double> A;
	Vec3d                     b;
	double                    c = 0;

	Quadric& operator+=(const Quadric& o)
	{
		A += o.A;
		b += o.b;
		c += o.c;
		return *this;
	}

	/// Adds the squared distance from the plane through p with unit normal n.
	void addPlane(const Vec3d& p, const Vec3d& n, double weight)
	{
		const double d = dot(n, p);
		A.addOuter(n, weight);
		b += n * (weight * d);
		c += weight * d * d;
	}

	/// Adds weight·|x - p|².
	void addPoint(const Vec3d& p, double weight)
	{
		A.addDiagonal(weight);
		b += p * weight;
		c += weight * dot(p, p);
	}

	double trace() const { return A.trace(); }

	/// Value at p; never negative in spite of rounding.
	double at(const Vec3d& p) const
	{
		const double value = dot(p, A * p) - 2 * dot(b, p) + c;
		return value > 0 ? value : 0;
	}

	/// The point of least value; `otherwise` if there are several such points.
	Vec3d lowest(const Vec3d& otherwise) const
	{
		const double size = trace();
		return A.solve(b, 1e-12 * size * size * size).value_or(otherwise);
	}
};

} // namespace gpr

#endif
