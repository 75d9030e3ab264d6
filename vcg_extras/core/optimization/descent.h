// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_DESCENT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_DESCENT_H

#include <vcg_extras/core/edit/move_guard.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <optional>

namespace gpr {

/// Steps that move all vertices at once (Jacobi) by terms (terms.h), under constraints
/// (edit/constraint.h) and within limits (edit/acceptance.h). This file has the steps on the
/// surface; the fit steps through space (fit.cpp).

inline Vec3f shortened(const Vec3f& a, float longest)
{
	const float l = length(a);
	return l > longest ? a * (longest / l) : a;
}

/// The move by descent with momentum (heavy ball, Polyak 1964): a share of the last move plus the
/// step of the terms.
inline Vec3f moveWithMomentum(const Vec3f& last, float share, const Vec3f& step, float longest)
{
	return shortened(last * share + step, longest);
}

/// Steps on the surface and its curves: the position of a vertex is the place of its record.
class SurfaceDescent {
public:
	SurfaceDescent(const Acceptance& limits, ResultMesh& result, Workers& workers) :
			guard_(limits, Shortening(), result.mesh, workers), r_(result), m_(result.mesh),
			workers_(workers), next_(result.vertex.size()), moves_(result.vertex.size(), 0)
	{
	}

	/// next(v) returns the new record of v, or none if v stays; all calls see the places before the
	/// step. A template, so that the terms in `next`, which take most of the time, are inlined into
	/// the loop.
	template <class Next>
	void step(const Next& next)
	{
		guard_.start();
		workers_.forEach(m_.vertexNum, [&](int v) {
			const std::optional<ResultVertex> to = next(v);
			moves_[v]                            = to.has_value();
			if (to) next_[v] = *to;
		});
		workers_.forEach(m_.vertexNum, [&](int v) {
			if (moves_[v]) m_.position[v] = next_[v].point.position;
		});
		guard_.takeOver();
		guard_.settle();
		workers_.forEach(m_.vertexNum, [&](int v) {
			moves_[v] = moves_[v] && m_.position[v] == next_[v].point.position;
			if (moves_[v]) r_.vertex[v] = next_[v];
		});
	}

	/// Whether v's move in the last step stood.
	bool moved(int v) const { return moves_[v] != 0; }

private:
	MoveGuard            guard_;
	ResultMesh&          r_;
	HalfEdgeMesh&        m_;
	Workers&             workers_;
	Buffer<ResultVertex> next_;
	Buffer<char>         moves_;
};

} // namespace gpr

#endif
