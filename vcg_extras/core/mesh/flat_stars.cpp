// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "flat_stars.h"

#include "sectors.h"

#include <array>

namespace gpr {

namespace {

/// The faces of a star, as vectors from its vertex.
class Star {
public:
	/// Returns false if there are too many faces.
	bool collect(const HalfEdgeMesh& m, int v)
	{
		const Vec3d middle(m.position[v]);
		bool        isRoom = true;
		forEachOutgoing(m, v, [&](int h) {
			isRoom = isRoom && num_ < maxNum;
			if (isRoom) spoke_[num_++] = Vec3d(m.position[m.target(h)]) - middle;
		});
		return isRoom;
	}

	bool isFlat()
	{
		Vec3d sum;
		for (int i = 0; i < num_; ++i) {
			normal_[i] = cross(spoke_[i], next(i));
			sum += normal_[i];
		}
		const double limit = double(flatCosine) * double(flatCosine) * squaredLength(sum);
		for (int i = 0; i < num_; ++i) {
			const double along  = dot(normal_[i], sum);
			const double length = squaredLength(normal_[i]);
			if (!(along > 0 && along * along >= limit * length)) return false;
			if (!(length > leastSine * squaredLength(spoke_[i]) * squaredLength(next(i))))
				return false;
		}
		return turnsOnce(sum);
	}

private:
	static constexpr int maxNum = 16; // nearly all vertices have fewer faces
	/// Squared sine of a corner's angle, far above the rounding of a double, below which the normal
	/// of the face is unreliable.
	static constexpr double leastSine = 1e-20;

	std::array<Vec3d, maxNum> spoke_, normal_;
	int                       num_ = 0;

	const Vec3d& next(int i) const { return spoke_[i + 1 < num_ ? i + 1 : 0]; }

	/// Whether the ring winds once round the normal: crosses a plane through the normal upwards
	/// once.
	bool turnsOnce(const Vec3d& normal) const
	{
		const Vec3d side    = cross(normal, spoke_[0]);
		int         upwards = 0;
		for (int i = 0; i < num_; ++i) {
			const bool isAbove     = i > 0 && dot(spoke_[i], side) > 0;
			const bool isNextAbove = i + 1 < num_ && dot(next(i), side) > 0;
			upwards += !isAbove && isNextAbove;
		}
		return upwards <= 1;
	}
};

bool isFlatStar(const HalfEdgeMesh& m, int v)
{
	if (m.isBorderVertex(v)) return false;
	Star star;
	return star.collect(m, v) && star.isFlat();
}

} // namespace

FlatStars::FlatStars(const HalfEdgeMesh& mesh, Workers& workers) :
		m_(mesh), isFlat_(std::size_t(mesh.vertexNum))
{
	workers.forEach(isFlat_.size(), [&](int v) { isFlat_[v] = isFlatStar(m_, v); });
}

} // namespace gpr
