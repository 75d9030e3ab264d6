// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_nearest.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/face_plane.h>

#include <cmath>

namespace gpr {

namespace {

class Descent {
public:
	Descent(const HalfEdgeMesh& mesh, const Vec3f& p, const Vec3f& facing) :
			m_(mesh), p_(p), facing_(facing), isAnyWay_(facing == Vec3f())
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
			if (isAnyWay_ || !(dot(m_.faceCross(h / 3), facing_) < 0)) tryFace(h / 3);
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

	/// Whether p lies over the inside of the nearest face. Then no neighbour of the face is nearer.
	bool isInside() const { return FacePlane(m_, at_.face).footOf(p_).isInside(); }

private:
	const HalfEdgeMesh& m_;
	Vec3f               p_, facing_;
	bool                isAnyWay_; ///< faces of either side count
	SurfacePoint        at_;
	float               squared_ = HUGE_VALF;
};

/// Goes from a corner of a face to a vertex that has no nearer neighbour.
int nearestVertex(const HalfEdgeMesh& m, int face, const Vec3f& p)
{
	int        nearest   = m.origin[3 * face];
	float      squared   = HUGE_VALF;
	const auto tryVertex = [&](int v) {
		const float of = squaredLength(m.position[v] - p);
		if (of >= squared) return;
		squared = of;
		nearest = v;
	};
	for (int h = 3 * face; h < 3 * face + 3; ++h)
		tryVertex(m.origin[h]);
	for (int from = -1; from != nearest;) {
		from = nearest;
		forEachNeighbour(m, from, tryVertex);
	}
	return nearest;
}

} // namespace

Vec3f nearestOnTheWay(const HalfEdgeMesh& m, const Vec3f& p, float enough, int& face)
{
	constexpr int maxHops = 64;
	Descent       descent(m, p, Vec3f());
	descent.tryFace(face);
	// First by vertices: a look at a vertex costs a tenth of a look at a face.
	if (descent.squared() > enough) descent.tryRound(nearestVertex(m, face, p));
	for (int i = 0; i < maxHops && descent.squared() > enough; ++i) {
		if (descent.isInside() || !descent.hop()) break;
	}
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
