// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_nearest.h"

#include <vcg_extras/core/base/triangle.h>

#include <cmath>

namespace gpr {

namespace {

class Descent {
public:
	Descent(const HalfEdgeMesh& mesh, const Vec3f& p, const Vec3f& facing) :
			m_(mesh), p_(p), facing_(facing)
	{
	}

	const SurfacePoint& at() const { return at_; }
	float               squared() const { return squared_; }

	void tryFace(int f)
	{
		const int*  c = &m_.origin[3 * f];
		const Vec3f q =
			nearestOnTriangle(p_, m_.position[c[0]], m_.position[c[1]], m_.position[c[2]]);
		const float squared = squaredLength(p_ - q);
		if (!(squared < squared_)) return;
		squared_ = squared;
		at_      = {q, f};
	}

	/// Whether a face round v is nearer.
	bool tryRound(int v)
	{
		const float before = squared_;
		forEachOutgoing(m_, v, [&](int h) {
			if (!(dot(m_.faceCross(h / 3), facing_) < 0)) tryFace(h / 3);
		});
		return squared_ < before;
	}

	/// Whether a face round the corners of the nearest one is nearer.
	bool hop()
	{
		const int* c        = &m_.origin[3 * at_.face];
		bool       isNearer = false;
		for (int k = 0; k < 3; ++k)
			isNearer = tryRound(c[k]) || isNearer;
		return isNearer;
	}

private:
	const HalfEdgeMesh& m_;
	Vec3f               p_, facing_;
	SurfacePoint        at_;
	float               squared_ = HUGE_VALF;
};

} // namespace

Vec3f nearestOnTheWay(const HalfEdgeMesh& m, const Vec3f& p, float enough, int& face)
{
	constexpr int maxHops = 64;
	Descent       descent(m, p, Vec3f());
	descent.tryFace(face);
	for (int i = 0; i < maxHops && descent.squared() > enough && descent.hop();)
		++i;
	face = descent.at().face;
	return descent.at().position;
}

SurfacePoint nearestByDescent(const HalfEdgeMesh& m, int from, const Vec3f& p, const Vec3f& facing)
{
	Descent descent(m, p, facing);
	for (bool isNearer = descent.tryRound(from); isNearer;)
		isNearer = descent.hop();
	return descent.at();
}

} // namespace gpr
