// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_SAME_PLACE_H
#define VCG_EXTRAS_CORE_MESH_SAME_PLACE_H

#include <vcg_extras/core/vec.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace gpr {

/// The largest distance, in working units, of points that count as the same place when a mesh is
/// sewn or welded: a millionth of the box, whose largest side is about 1. Far below any useful edge
/// length, and above the noise of coordinates in text or float.
constexpr float samePlace = 1e-6f;

/// Whether a comes before b, by x, y, z.
template <class S>
bool isBefore(const Vec3<S>& a, const Vec3<S>& b)
{
	if (a.x != b.x) return a.x < b.x;
	return a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Values by place, in the order of isBefore, which the constructor takes.
template <class T>
using PlaceMap = std::map<Vec3f, T, bool (*)(const Vec3f&, const Vec3f&)>;

/// Finds points at the same place: a hash table of cells, each with a chain of points.
class SamePlaceTable {
public:
	/// pointNum: the largest number of points.
	explicit SamePlaceTable(std::size_t pointNum);

	/// Returns the least number of a stored point within samePlace of p. Without such a point
	/// stores p and returns its own number. Cost: O(1) if places are far apart.
	int findOrPut(const Vec3f& p, int number);

private:
	struct Entry {
		Vec3f point;
		int   number;
		int   next; ///< next entry in the chain, or -1
	};
	std::vector<int>   first_; ///< per slot: the first entry, or -1; the size is a power of two
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
