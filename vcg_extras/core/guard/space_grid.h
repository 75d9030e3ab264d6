// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_SPACE_GRID_H
#define VCG_EXTRAS_CORE_GUARD_SPACE_GRID_H

#include <vcg_extras/core/base/box.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gpr {

/// A grid of equal cubes over a box. Points beyond the box belong to the nearest cube.
class SpaceGrid {
public:
	/// cubeNum: along the longest edge of the box.
	SpaceGrid(const Box<float>& box, int cubeNum) :
			low_(box.low), perUnit_(float(cubeNum) / std::max(box.largestSide(), 1e-30f))
	{
		const Vec3f size = (box.high - box.low) * perUnit_;
		for (int axis = 0; axis < 3; ++axis)
			num_[axis] = std::clamp(int(std::ceil(coordinate(size, axis))), 1, cubeNum);
	}

	int cubeNum() const { return num_[0] * num_[1] * num_[2]; }
	/// Along the longest edge of the box.
	int cubeNumOfEdge() const { return std::max({num_[0], num_[1], num_[2]}); }
	/// On the largest side of the box.
	int cubeNumOfSide() const
	{
		return std::max({num_[0] * num_[1], num_[1] * num_[2], num_[2] * num_[0]});
	}

	int cubeOf(const Vec3f& p) const { return index(at(p, 0), at(p, 1), at(p, 2)); }

	/// Calls visit(cube) for all cubes that a box may meet.
	template <class Visit>
	void forEachCube(const Box<float>& box, const Visit& visit) const
	{
		for (int z = at(box.low, 2); z <= at(box.high, 2); ++z) {
			for (int y = at(box.low, 1); y <= at(box.high, 1); ++y) {
				for (int x = at(box.low, 0); x <= at(box.high, 0); ++x)
					visit(index(x, y, z));
			}
		}
	}
	/// The number of these cubes.
	std::int64_t cubeNumOf(const Box<float>& box) const
	{
		std::int64_t num = 1;
		for (int axis = 0; axis < 3; ++axis)
			num *= at(box.high, axis) - at(box.low, axis) + 1;
		return num;
	}

private:
	Vec3f low_;
	float perUnit_;
	int   num_[3];

	int index(int x, int y, int z) const { return (z * num_[1] + y) * num_[0] + x; }
	/// Never falls with the coordinate: cubes have no point in common, whatever the rounding.
	int at(const Vec3f& p, int axis) const
	{
		const float along = (coordinate(p, axis) - coordinate(low_, axis)) * perUnit_;
		return int(std::min(std::max(along, 0.0f), float(num_[axis] - 1)));
	}
};

} // namespace gpr

#endif
