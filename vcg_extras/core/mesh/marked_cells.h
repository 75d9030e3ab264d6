// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_MARKED_CELLS_H
#define VCG_EXTRAS_CORE_MESH_MARKED_CELLS_H

#include <vcg_extras/core/base/box.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gpr {

/// A coarse grid over a cube, for a quick test whether a box may meet any of many marked boxes. A
/// mark covers all cells where a small box may begin that meets the marked box, so that the test of
/// a small box is a single look. Small enough to stay in the cache.
class MarkedCells {
public:
	MarkedCells(const Vec3f& low, float side) :
			low_(low), width_(side / cellNum), isMarked_(cellNum * cellNum * cellNum)
	{
	}

	void mark(const Box<float>& box)
	{
		const Vec3f margin(width_, width_, width_);
		forEachCell(cellAt(box.low - margin), cellAt(box.high), [&](std::size_t cell) {
			isMarked_[cell] = 1;
			return true;
		});
	}

	/// True for each box that meets a marked box.
	bool mayMeet(const Box<float>& box) const
	{
		const Cell low = cellAt(box.low);
		if (box.largestSide() <= 0.99f * width_) return isMarked_[indexOf(low)] != 0;
		return !forEachCell(low, cellAt(box.high),
							[&](std::size_t cell) { return isMarked_[cell] == 0; });
	}

private:
	static constexpr int cellNum = 64; // along each axis
	struct Cell {
		int x, y, z;
	};
	Vec3f             low_;
	float             width_; ///< of a cell
	std::vector<char> isMarked_;

	Cell cellAt(const Vec3f& p) const
	{
		const float scale = 1 / width_;
		const auto  along = [=](float c) {
            return int(std::min(float(cellNum - 1), std::max(0.0f, c * scale)));
		};
		return {along(p.x - low_.x), along(p.y - low_.y), along(p.z - low_.z)};
	}
	static std::size_t indexOf(const Cell& c)
	{
		return (std::size_t(c.x) * cellNum + c.y) * cellNum + c.z;
	}

	/// Calls visit(cell) until visit returns false; returns whether all cells were visited.
	template <class Visit>
	static bool forEachCell(const Cell& low, const Cell& high, const Visit& visit)
	{
		for (int x = low.x; x <= high.x; ++x) {
			for (int y = low.y; y <= high.y; ++y) {
				for (int z = low.z; z <= high.z; ++z) {
					if (!visit(indexOf({x, y, z}))) return false;
				}
			}
		}
		return true;
	}
};

} // namespace gpr

#endif
