// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_gap.h"

#include "local_nearest.h"

#include <vcg_extras/core/mesh/face_plane.h>

namespace gpr {

namespace {

/// Steps of the lattice along an edge.
constexpr int latticeSteps = 4;

void widen(const Vec3f& onTriangle, const Vec3f& onSurface, Gap& gap)
{
	const Vec3f way     = onSurface - onTriangle;
	const float squared = squaredLength(way);
	if (squared > gap.squared) gap = {squared, way, onTriangle};
}

/// Nearest point from several first faces: a rim may stop the search from `face`, and a search from
/// a corner may not meet the rim.
Vec3f nearestFromCorners(const HalfEdgeMesh& m, const std::array<int, 3>& seed, const Vec3f& p,
						 float enough, int& face)
{
	Vec3f nearest = nearestOnTheWay(m, p, enough, face);
	for (int k = 0; k < 3 && squaredLength(nearest - p) > enough; ++k) {
		int         other = seed[k];
		const Vec3f q     = nearestOnTheWay(m, p, enough, other);
		if (squaredLength(q - p) >= squaredLength(nearest - p)) continue;
		nearest = q;
		face    = other;
	}
	return nearest;
}

} // namespace

Gap gapFromTriangle(const HalfEdgeMesh& m, const std::array<Vec3f, 3>& t,
					const std::array<int, 3>& seed, float squaredNear, float squaredMost)
{
	Gap gap  = {squaredNear, Vec3f(), Vec3f()};
	int face = seed[0];
	for (int i = 0; i <= latticeSteps; ++i) {
		for (int k = 0; i + k <= latticeSteps; ++k) {
			const float x = float(i) / latticeSteps, y = float(k) / latticeSteps;
			const Vec3f p = t[0] * (1 - x - y) + t[1] * x + t[2] * y;
			widen(p, nearestFromCorners(m, seed, p, gap.squared, face), gap);
			if (gap.squared > squaredMost) return gap;
		}
	}
	return gap;
}

SurfaceGaps::SurfaceGaps(const Surface& surface, const ClosestFaceMap& map,
						 const HalfEdgeMesh& result, const Buffer<SurfacePoint>& point,
						 float near) :
		s_(surface.mesh),
		map_(map), m_(result), point_(point), squaredNear_(near * near)
{
}

/// Widens the gap by the vertices of the surface closest to f, each measured to the result near f.
void SurfaceGaps::lookFromSurface(int f, Gap& gap) const
{
	const FacePlane plane(m_, f);
	for (const int* i = map_.begin(f); i != map_.end(f); ++i) {
		int         face = f;
		const Vec3f p    = s_.position[*i];
		// Most vertices lie over the face and near.
		if (plane.isNearOver(p, gap.squared)) continue;
		widen(nearestOnTheWay(m_, p, gap.squared, face), p, gap);
	}
}

void SurfaceGaps::lookFromTriangle(int f, Gap& gap, float squaredMost) const
{
	const int* c   = &m_.origin[3 * f];
	const Gap  own = gapFromTriangle(s_, {m_.position[c[0]], m_.position[c[1]], m_.position[c[2]]},
									 {point_[c[0]].face, point_[c[1]].face, point_[c[2]].face},
									 gap.squared, squaredMost);
	if (own.squared > gap.squared) gap = own;
}

Gap SurfaceGaps::gapAt(int f, float squaredMost) const
{
	Gap gap = nearEnough();
	lookFromTriangle(f, gap, squaredMost);
	lookFromSurface(f, gap);
	return gap;
}

bool SurfaceGaps::isWithin(int f, float squared) const
{
	Gap gap = {squared, Vec3f(), Vec3f()};
	lookFromSurface(f, gap);
	if (gap.squared <= squared) lookFromTriangle(f, gap, squared);
	return gap.squared <= squared;
}

Buffer<float> SurfaceGaps::measureAll(Workers& workers) const
{
	Buffer<char> isFar(m_.vertexNum);
	workers.forEach(m_.vertexNum, [&](int v) { isFar[v] = isFarVertex(v); });
	Buffer<float> squared(m_.faceNum);
	workers.forEach(m_.faceNum, [&](int f) {
		const int* c   = &m_.origin[3 * f];
		Gap        gap = nearEnough();
		if (isFar[c[0]] || isFar[c[1]] || isFar[c[2]]) lookFromTriangle(f, gap, HUGE_VALF);
		lookFromSurface(f, gap);
		squared[f] = gap.squared;
	});
	return squared;
}

/// Whether a vertex of the result is farther off than near.
bool SurfaceGaps::isFarVertex(int v) const
{
	const Vec3f        p     = m_.position[v];
	const SurfacePoint point = point_[v];
	if (squaredLength(p - point.position) <= squaredNear_) return false;
	int face = point.face;
	return squaredLength(nearestOnTheWay(s_, p, squaredNear_, face) - p) > squaredNear_;
}

} // namespace gpr
