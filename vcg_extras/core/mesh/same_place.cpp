// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "same_place.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Wide cells: most points are far from the next cell.
std::int64_t cellOf(float c)
{
	return std::int64_t(std::floor(c / (16 * samePlace)));
}

} // namespace

SamePlaceTable::SamePlaceTable(std::size_t pointNum)
{
	std::size_t size = 64;
	while (size < 2 * pointNum)
		size *= 2;
	first_.assign(size, -1);
	entry_.reserve(pointNum);
}

int SamePlaceTable::findOrPut(const Vec3f& p, int number)
{
	int best = number;
	for (std::int64_t x = cellOf(p.x - samePlace); x <= cellOf(p.x + samePlace); ++x) {
		for (std::int64_t y = cellOf(p.y - samePlace); y <= cellOf(p.y + samePlace); ++y) {
			for (std::int64_t z = cellOf(p.z - samePlace); z <= cellOf(p.z + samePlace); ++z)
				best = leastNear(p, slotOf(x, y, z), best);
		}
	}
	if (best == number) put(p, number);
	return best;
}

std::size_t SamePlaceTable::slotOf(std::int64_t x, std::int64_t y, std::int64_t z) const
{
	const std::uint64_t cell = std::uint64_t(x) * 0x9e3779b97f4a7c15ull ^
							   std::uint64_t(y) * 0xc2b2ae3d27d4eb4full ^
							   std::uint64_t(z) * 0x165667b19e3779f9ull;
	return std::size_t(mixedBits(cell)) & (first_.size() - 1);
}

int SamePlaceTable::leastNear(const Vec3f& p, std::size_t slot, int otherwise) const
{
	int best = otherwise;
	for (int i = first_[slot]; i >= 0; i = entry_[i].next) {
		const Entry& e = entry_[i];
		if (squaredLength(e.point - p) <= samePlace * samePlace) best = std::min(best, e.number);
	}
	return best;
}

void SamePlaceTable::put(const Vec3f& p, int number)
{
	const std::size_t slot = slotOf(cellOf(p.x), cellOf(p.y), cellOf(p.z));
	entry_.push_back({p, number, first_[slot]});
	first_[slot] = int(entry_.size()) - 1;
}

} // namespace gpr
