// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "flat_stars.h"

#include "sectors.h"

namespace gpr {

namespace {

/// Squared sine of a corner's angle, far above the rounding of a double, below which the normal of
/// the face is unreliable.
constexpr double leastSine = 1e-20;

/// Calls visit(h, a, b) for every half-edge h from v; a and b are the vectors from v to its target
/// and apex.
template <class Visit>
void forEachCorner(const HalfEdgeMesh& m, int v, const Visit& visit)
{
	const Vec3d middle(m.position[v]);
	Vec3d       a = Vec3d(m.position[m.target(m.outgoing[v])]) - middle;
	forEachOutgoing(m, v, [&](int h) {
		const Vec3d b = Vec3d(m.position[m.apex(h)]) - middle;
		visit(h, a, b);
		a = b;
	});
}

bool isFlatStar(const HalfEdgeMesh& m, int v)
{
	if (m.isBorderVertex(v)) return false;
	Vec3d sum;
	forEachCorner(m, v, [&](int, const Vec3d& a, const Vec3d& b) { sum += cross(a, b); });
	const double limit = double(flatCosine) * double(flatCosine) * squaredLength(sum);
	// The ring winds once round the normal if it crosses a plane through the normal and its first
	// place upwards once.
	const int first = m.target(m.outgoing[v]);
	Vec3d     side;
	bool      isFlat = true, isAbove = false;
	int       upwards = 0;
	forEachCorner(m, v, [&](int h, const Vec3d& a, const Vec3d& b) {
		if (h == m.outgoing[v]) side = cross(sum, a);
		const Vec3d  normal = cross(a, b);
		const double along = dot(normal, sum), length = squaredLength(normal);
		isFlat = isFlat && along > 0 && along * along >= limit * length &&
				 length > leastSine * squaredLength(a) * squaredLength(b);
		const bool isNextAbove = m.apex(h) != first && dot(b, side) > 0;
		upwards += !isAbove && isNextAbove;
		isAbove = isNextAbove;
	});
	return isFlat && upwards <= 1;
}

} // namespace

FlatStars::FlatStars(const HalfEdgeMesh& mesh, Workers& workers) :
		m_(mesh), isFlat_(std::size_t(mesh.vertexNum))
{
	workers.forEach(isFlat_.size(), [&](int v) { isFlat_[v] = isFlatStar(m_, v); });
}

} // namespace gpr
