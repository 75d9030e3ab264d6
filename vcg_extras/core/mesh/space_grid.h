// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_SPACE_GRID_H
#define VCG_EXTRAS_CORE_MESH_SPACE_GRID_H

#include <vcg_extras/core/base/box.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gpr {

/// A grid of equal cubes over a box. Points beyond the box belong to the nearest cube. The grid
/// over an empty box has a single cube.
class SpaceGrid {
public:
	/// cubeNum: along the longest edge of the box.
	SpaceGrid(const Box<float>& box, int cubeNum) :
			low_(box.low), perUnit_(float(cubeNum) / std::max(box.largestSide(), 1e-30f))
	{
		const Vec3f size = (box.high - box.low) * perUnit_;
		for (int axis = 0; axis < 3; ++axis)
			num_[axis] = wholeUpTo(std::ceil(coordinate(size, axis)), 1, cubeNum);
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

	/// Calls visit(cube) for all cubes that a box may meet, until visit returns false; returns
	/// whether all of these cubes were visited.
	template <class Visit>
	bool forEachCube(const Box<float>& box, const Visit& visit) const
	{
		const int lowX = at(box.low, 0), highX = at(box.high, 0);
		const int lowY = at(box.low, 1), highY = at(box.high, 1);
		for (int z = at(box.low, 2); z <= at(box.high, 2); ++z) {
			for (int y = lowY; y <= highY; ++y) {
				for (int x = lowX; x <= highX; ++x) {
					if (!visit(index(x, y, z))) return false;
				}
			}
		}
		return true;
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
		return wholeUpTo(along, 0, num_[axis] - 1);
	}
	/// `least` if the value is not a number, as for the sides of an empty box.
	static int wholeUpTo(float value, int least, int most)
	{
		return int(std::min(std::max(float(least), value), float(most)));
	}
};

/// Marks in a coarse grid over a cube, for a quick test whether a box may meet any of many marked
/// boxes. A mark covers all cubes of the grid where a small box may begin that meets the marked
/// box, so that the test of a small box is a single look. Small enough to stay in the cache.
class MarkedCells {
public:
	MarkedCells(const Vec3f& low, float side) :
			grid_({low, low + Vec3f(side, side, side)}, cubeNum), width_(side / cubeNum),
			isMarked_(cubeNum * cubeNum * cubeNum)
	{
	}

	void mark(const Box<float>& box)
	{
		const Vec3f margin(width_, width_, width_);
		grid_.forEachCube({box.low - margin, box.high}, [&](int cube) {
			isMarked_[cube] = 1;
			return true;
		});
	}

	/// True for each box that meets a marked box.
	bool mayMeet(const Box<float>& box) const
	{
		if (box.largestSide() <= 0.99f * width_) return isMarked_[grid_.cubeOf(box.low)] != 0;
		return !grid_.forEachCube(box, [&](int cube) { return isMarked_[cube] == 0; });
	}

private:
	static constexpr int cubeNum = 64; // along each axis
	SpaceGrid            grid_;
	float                width_; ///< of a cube
	std::vector<char>    isMarked_;
};

} // namespace gpr

#endif
