// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cover_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gpr {

namespace {

/// Most triangles to follow; a larger piece is better cut.
constexpr int maxTriangles = 192;

/// The reached triangles, in the order of the search.
class Visited {
public:
	int  num() const { return num_; }
	int  operator[](int i) const { return triangle_[i]; }
	bool isFull() const { return num_ == maxTriangles; }

	/// Adds a triangle unless known. The list must not be full.
	void add(int triangle)
	{
		std::uint32_t slot = std::uint32_t(triangle) * 2654435769u >> shift;
		for (; place_[slot] != 0; slot = (slot + 1) % slotNum)
			if (triangle_[place_[slot] - 1] == triangle) return;
		triangle_[num_++] = triangle;
		place_[slot]      = std::uint8_t(num_);
	}

private:
	static constexpr int           shift   = 23;
	static constexpr std::uint32_t slotNum = 1u << (32 - shift);
	static_assert(maxTriangles < 256, "places are bytes");

	std::uint8_t place_[slotNum] = {}; ///< 1 + index in triangle_, 0: free
	int          triangle_[maxTriangles];
	int          num_ = 0;
};

/// A point seen along the piece's normal: two coordinates in its plane, and the height above it.
using Seen = Vec3d;

/// 1 if p surely lies to the left of the line from a to b, -1 if to the right; 0: unsure.
int sideOfLine(const Seen& a, const Seen& b, const Seen& p, double margin)
{
	const double abx = b.x - a.x, aby = b.y - a.y, apx = p.x - a.x, apy = p.y - a.y;
	const double side  = abx * apy - aby * apx;
	const double least = margin * (std::abs(abx) + std::abs(aby) + std::abs(apx) + std::abs(apy));
	if (side > least) return 1;
	return side < -least ? -1 : 0;
}

/// The piece seen along its normal. The first corner is the origin, the second lies on the x axis.
class Window {
public:
	Window(const Triangle& piece, double rounding) : origin_(piece[0]), margin_(16 * rounding)
	{
		const Vec3d  ab = piece[1] - piece[0], ac = piece[2] - piece[0], n = cross(ab, ac);
		const double longest =
			std::max({squaredLength(ab), squaredLength(ac), squaredLength(ac - ab)});
		constexpr double needle = 1e-6;
		const double     least  = std::max(needle * longest, 4 * margin_ * std::sqrt(longest));
		isUsable_               = length(n) > least;
		if (!isUsable_) return;
		x_ = normalized(ab);
		z_ = normalized(n);
		y_ = cross(z_, x_);
		for (std::size_t k = 0; k < 3; ++k)
			corner_[k] = seen(piece[k]);
		for (std::size_t k = 0; k < 3; ++k) {
			const Seen   along = corner_[(k + 1) % 3] - corner_[k];
			const double scale = 1 / std::sqrt(along.x * along.x + along.y * along.y);
			inwards_[k]        = {-along.y * scale, along.x * scale, 0};
		}
	}

	bool   isUsable() const { return isUsable_; }
	double margin() const { return margin_; }

	Seen seen(const Vec3d& p) const
	{
		const Vec3d v = p - origin_;
		return {dot(v, x_), dot(v, y_), dot(v, z_)};
	}

	/// A point in the middle, but away from the vertices and edges of regular meshes.
	Seen middle() const { return corner_[0] * 0.31 + corner_[1] * 0.36 + corner_[2] * 0.33; }

	/// Distance of p to the inner side of the line through an edge of the piece.
	double inside(const Seen& p, std::size_t edge) const
	{
		const Seen v = p - corner_[edge];
		return v.x * inwards_[edge].x + v.y * inwards_[edge].y;
	}

	/// False only if a segment surely lies beside the piece.
	bool mayMeet(const Seen& p, const Seen& q) const
	{
		for (std::size_t k = 0; k < 3; ++k)
			if (inside(p, k) < -margin_ && inside(q, k) < -margin_) return false;
		return !isBesideLine(p, q);
	}

private:
	Vec3d  origin_, x_, y_, z_;
	Seen   corner_[3];
	Vec3d  inwards_[3]; ///< unit, of the edge from each corner to the next
	double margin_;
	bool   isUsable_ = false;

	/// Whether all of the piece lies on one side of the line through p and q.
	bool isBesideLine(const Seen& p, const Seen& q) const
	{
		bool left = true, right = true;
		for (const Seen& c : corner_) {
			const int side = sideOfLine(p, q, c, margin_);
			left           = left && side > 0;
			right          = right && side < 0;
		}
		return left || right;
	}
};

/// Largest |height| of the part of a triangle that lies over the piece, or slightly beside it.
double largestHeightInside(const Window& window, const Seen (&t)[3])
{
	Seen polygon[2][9] = {{t[0], t[1], t[2]}, {}};
	int  num           = 3;
	for (std::size_t edge = 0; edge < 3; ++edge) {
		const Seen* from = polygon[edge % 2];
		Seen*       to   = polygon[(edge + 1) % 2];
		int         kept = 0;
		for (int i = 0; i < num; ++i) {
			const Seen&  p = from[i];
			const Seen&  q = from[(i + 1) % num];
			const double d = window.inside(p, edge) + window.margin();
			const double e = window.inside(q, edge) + window.margin();
			if (d >= 0) to[kept++] = p;
			if ((d < 0) != (e < 0)) to[kept++] = p + (q - p) * (d / (d - e));
		}
		num = kept;
	}
	double largest = 0;
	for (int i = 0; i < num; ++i)
		largest = std::max(largest, std::abs(polygon[1][i].z));
	return largest;
}

class Cover {
public:
	Cover(const Window& window, const TriangleTree& surface, double limit) :
			window_(window), surface_(surface), limit_(limit)
	{
	}

	double bound(int start)
	{
		visited_.add(start);
		for (int i = 0; i < visited_.num(); ++i)
			if (!take(visited_[i])) return HUGE_VAL;
		return coverNum_ % 2 == 1 ? largest_ : HUGE_VAL;
	}

private:
	const Window&       window_;
	const TriangleTree& surface_;
	double              limit_;
	Visited             visited_;
	int                 coverNum_ = 0; ///< triangles over the middle of the piece
	double              largest_  = 0;

	bool take(int triangle)
	{
		Seen t[3];
		for (std::size_t k = 0; k < 3; ++k)
			t[k] = window_.seen(surface_.triangle(triangle)[k]);
		return isLow(t) && isCounted(t) && isFollowed(triangle, t);
	}

	bool isLow(const Seen (&t)[3])
	{
		double height = std::max({std::abs(t[0].z), std::abs(t[1].z), std::abs(t[2].z)});
		if (height > limit_) height = largestHeightInside(window_, t);
		largest_ = std::max(largest_, height);
		return height <= limit_;
	}

	/// Counts the triangle if it covers the middle of the piece. False if that is unsure.
	bool isCounted(const Seen (&t)[3])
	{
		int left = 0, right = 0;
		for (std::size_t k = 0; k < 3; ++k) {
			const int side = sideOfLine(t[k], t[(k + 1) % 3], window_.middle(), window_.margin());
			left += side > 0;
			right += side < 0;
		}
		const bool isOver = left == 3 || right == 3;
		coverNum_ += isOver;
		return isOver || (left > 0 && right > 0);
	}

	bool isFollowed(int triangle, const Seen (&t)[3])
	{
		for (int k = 0; k < 3; ++k) {
			if (!window_.mayMeet(t[k], t[(k + 1) % 3])) continue;
			const int next = surface_.neighbour(triangle, k);
			if (next < 0 || visited_.isFull()) return false;
			visited_.add(next);
		}
		return true;
	}
};

} // namespace

double coverBound(const Triangle& piece, const TriangleTree& surface, int start, double limit,
				  double rounding)
{
	const Window window(piece, rounding);
	if (!window.isUsable()) return HUGE_VAL;
	return Cover(window, surface, limit).bound(start);
}

} // namespace gpr
