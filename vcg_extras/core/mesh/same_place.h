// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_SAME_PLACE_H
#define VCG_EXTRAS_CORE_MESH_SAME_PLACE_H

#include <vcg_extras/core/vec.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpr {

/// Points this near to each other, in working units, lie at one place where parts of a mesh are
/// joined: a millionth of the box, whose largest side is about 1. That is far below any edge worth
/// keeping, and above the noise of coordinates that went through text or float.
constexpr float samePlace = 1e-6f;

/// An order of places, by x, y, z.
inline bool isBefore(const Vec3f& a, const Vec3f& b)
{
	if (a.x != b.x) return a.x < b.x;
	return a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Finds points at the same place: a hash table of cells, each with a chain of points.
class SamePlaceTable {
public:
	/// pointNum: how many will be put in at most.
	explicit SamePlaceTable(std::size_t pointNum);

	/// The least number of the points within samePlace of p that were put in before; where there is
	/// none p is put in, and its own number returned. Cost: O(1) where places are far apart.
	int findOrPut(const Vec3f& p, int number);

private:
	struct Entry {
		Vec3f point;
		int   number;
		int   next; ///< in the chain, or -1
	};
	std::vector<int>   first_; ///< per slot, or -1; a power of two of them
	std::vector<Entry> entry_;

	std::size_t slotOf(std::int64_t x, std::int64_t y, std::int64_t z) const;
	int         leastNear(const Vec3f& p, std::size_t slot, int otherwise) const;
	void        put(const Vec3f& p, int number);
};

/// Spreads the bits of x over all 64 (the finalizer of splitmix64).
inline std::uint64_t mixedBits(std::uint64_t x)
{
	x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
	x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
	return x ^ (x >> 31);
}

} // namespace gpr

#endif
