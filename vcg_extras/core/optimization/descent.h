// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_DESCENT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_DESCENT_H

#include <vcg_extras/core/edit/move_guard.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <optional>

namespace gpr {

/// Steps that move all vertices at once (Jacobi) to where terms (terms.h) want them under their
/// constraints (edit/constraint.h), within limits (edit/acceptance.h). Here are the steps on the
/// surface; the fit steps through space (fit.cpp).

inline Vec3f shortened(const Vec3f& a, float longest)
{
	const float l = length(a);
	return l > longest ? a * (longest / l) : a;
}

/// The move by descent with momentum (heavy ball, Polyak 1964): this share of the last one again,
/// and the step that the terms want.
inline Vec3f moveWithMomentum(const Vec3f& last, float share, const Vec3f& step, float longest)
{
	return shortened(last * share + step, longest);
}

/// Steps on the surface and its curves: a vertex lies where its record does.
class SurfaceDescent {
public:
	SurfaceDescent(const Acceptance& limits, ResultMesh& result, Workers& workers) :
			guard_(limits, Shortening(), result.mesh, workers), r_(result), m_(result.mesh),
			workers_(workers), next_(result.vertex.size()), moves_(result.vertex.size(), 0)
	{
	}

	/// next(v) is the record that v shall have, or none where v stays; all see the places before
	/// the step. A template, as the terms that `next` is made of take most of the time: they are
	/// inlined into the loop.
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
