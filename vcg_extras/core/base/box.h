// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_BOX_H
#define VCG_EXTRAS_CORE_BASE_BOX_H

#include <vcg_extras/core/vec.h>

#include <algorithm>
#include <limits>

namespace gpr {

/// A box along the axes; empty at first.
template <class S>
struct Box {
	static constexpr S infinite = std::numeric_limits<S>::infinity();

	Vec3<S> low{infinite, infinite, infinite};
	Vec3<S> high{-infinite, -infinite, -infinite};

	Box() = default;
	Box(const Vec3<S>& a, const Vec3<S>& b) : low(a), high(b) {}

	/// The box of some points: an array or another range.
	template <class Points>
	static Box ofPoints(const Points& points)
	{
		Box box;
		for (const Vec3<S>& p : points)
			box.add(p);
		return box;
	}

	void add(const Vec3<S>& p) { *this += Box(p, p); }
	/// Enlarges the box by box b. An operator, so that Workers::sum can join the boxes of pieces.
	Box& operator+=(const Box& b)
	{
		// By value: a single instruction each, while std::min on members makes branches.
		const auto less = [](S x, S y) { return y < x ? y : x; };
		const auto more = [](S x, S y) { return x < y ? y : x; };
		low             = {less(low.x, b.low.x), less(low.y, b.low.y), less(low.z, b.low.z)};
		high            = {more(high.x, b.high.x), more(high.y, b.high.y), more(high.z, b.high.z)};
		return *this;
	}

	bool isEmpty() const { return !(high.x >= low.x); }
	/// 0 for an empty box.
	S diagonal() const { return isEmpty() ? S(0) : length(high - low); }
	/// Negative for an empty box.
	S largestSide() const
	{
		return std::max(high.x - low.x, std::max(high.y - low.y, high.z - low.z));
	}
	/// Squared distance of a point from the box, computed in the type of the point; 0 inside.
	template <class P>
	P squaredDistance(const Vec3<P>& p) const
	{
		const auto beyond = [](S least, P at, S most) {
			return std::max({P(least) - at, at - P(most), P(0)});
		};
		return squaredLength(Vec3<P>{beyond(low.x, p.x, high.x), beyond(low.y, p.y, high.y),
									 beyond(low.z, p.z, high.z)});
	}
	bool meets(const Box& b) const
	{
		return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y &&
			   low.z <= b.high.z && b.low.z <= high.z;
	}
};

} // namespace gpr

#endif
