// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_delaunay.h"

#include <algorithm>

namespace gpr {

namespace {

/// Tolerances over squared edge lengths. Coordinates come from floats with errors of 1e-7, whose
/// squares are far smaller; doubles have errors of 1e-16.
constexpr double inLineTolerance   = 1e-9;
constexpr double onCircleTolerance = 1e-9;
/// Most flips over the square of the number of edges; rounding could flip a diagonal for ever.
constexpr int maxFlipsFactor = 4;

/// Links edge y of the patch to `beyond`, the edge on its other side.
void hand(HolePatch& patch, int beyond, int y)
{
	patch.across[y] = beyond;
	if (beyond >= 0) patch.across[beyond] = y;
}

///      c               c        The triangles of x = (a, b, c) and y = (b, a, d) become
///    / | \           /   \      (a, d, c) and (b, c, d).
///   a  |  b   from  a-----b
///    \ | /           \   /
///      d               d
void flipDiagonal(HolePatch& patch, int x)
{
	const int y  = patch.across[x];
	const int xn = nextInFace(x), xp = prevInFace(x), yn = nextInFace(y), yp = prevInFace(y);
	const int c = patch.corner[xp], d = patch.corner[yp];
	const int beyondBC = patch.across[xn], beyondAD = patch.across[yn];
	patch.corner[xn] = d;
	patch.corner[yn] = c;
	hand(patch, beyondAD, x);
	hand(patch, beyondBC, y);
	hand(patch, yn, xn);
}

} // namespace

bool PolygonDelaunay::triangulate(const std::vector<Vec2d>& polygon, HolePatch& patch)
{
	patch.corner.clear();
	patch.across.clear();
	if (polygon.size() < 3) return polygon.size() == 2;
	begin(polygon);
	if (!cutEars(patch)) return false;
	makeDelaunay(patch);
	return true;
}

void PolygonDelaunay::begin(const std::vector<Vec2d>& polygon)
{
	const int n    = int(polygon.size());
	p_             = polygon.data();
	double longest = 0;
	corner_.resize(n);
	for (int i = 0; i < n; ++i) {
		const int   after = i + 1 < n ? i + 1 : 0;
		const Vec2d edge  = p_[after] - p_[i];
		longest           = std::max(longest, dot(edge, edge));
		corner_[i]        = {i > 0 ? i - 1 : n - 1, after, -1 - i, false};
	}
	inLine_ = inLineTolerance * longest;
	for (int i = 0; i < n; ++i)
		classify(i);
}

/// Twice the signed area of three corners.
double PolygonDelaunay::turn(int i, int j, int k) const
{
	return cross(p_[j] - p_[i], p_[k] - p_[i]);
}

void PolygonDelaunay::classify(int i)
{
	// NaN counts as reflex too: then no ear is found, and the triangulation fails.
	corner_[i].isReflex = !(turn(corner_[i].before, i, corner_[i].after) > inLine_);
}

bool PolygonDelaunay::isForbidden(int i, int j) const
{
	return std::any_of(forbidden.begin(), forbidden.end(), [&](const std::pair<int, int>& pair) {
		return pair == std::pair(i, j) || pair == std::pair(j, i);
	});
}

/// Whether the triangle at corner i lies within the rest of the polygon. Only reflex corners can
/// lie in the triangle.
bool PolygonDelaunay::isEar(int i) const
{
	const int a = corner_[i].before, b = corner_[i].after;
	if (corner_[i].isReflex) return false;
	const int end = corner_[a].before;
	for (int k = corner_[b].after; k != a; k = corner_[k].after) {
		if (!corner_[k].isReflex) continue;
		if (turn(a, i, k) >= 0 && turn(i, b, k) >= 0 && turn(b, a, k) >= 0) return false;
	}
	// The last three corners have all their edges already.
	return end == b || !isForbidden(a, b);
}

void PolygonDelaunay::cutEar(int i, HolePatch& patch)
{
	const int a = corner_[i].before, b = corner_[i].after;
	const int x = int(patch.corner.size());
	patch.corner.insert(patch.corner.end(), {a, i, b});
	patch.across.insert(patch.across.end(), 3, 0);
	hand(patch, corner_[a].beyond, x);
	hand(patch, corner_[i].beyond, x + 1);
	corner_[a].beyond = x + 2;
	corner_[a].after  = b;
	corner_[b].before = a;
	// The third edge of the last triangle is the rest of the polygon.
	if (corner_[b].after == a) hand(patch, corner_[b].beyond, x + 2);
}

/// Tries the corners in turn, so that ears come from all sides; gives up after a turn without an
/// ear.
bool PolygonDelaunay::cutEars(HolePatch& patch)
{
	int i = 0, tried = 0;
	for (int left = int(corner_.size()); left > 2;) {
		if (tried == left) return false;
		const int before = corner_[i].before, after = corner_[i].after;
		if (!isEar(i)) {
			++tried;
			i = after;
			continue;
		}
		cutEar(i, patch);
		classify(before);
		classify(after);
		tried = 0;
		--left;
		// Skips a neighbour: otherwise the ears would make a fan.
		i = corner_[after].after;
	}
	return true;
}

/// Whether the sum of the two angles opposite diagonal x is at most 180°.
bool PolygonDelaunay::isDelaunay(const HolePatch& patch, int x) const
{
	const int    y = patch.across[x];
	const Vec2d  a = p_[patch.corner[x]], b = p_[patch.corner[nextInFace(x)]];
	const Vec2d  c = p_[patch.corner[prevInFace(x)]], d = p_[patch.corner[prevInFace(y)]];
	const Vec2d  ca = a - c, cb = b - c, da = a - d, db = b - d;
	const double sin1 = cross(ca, cb), cos1 = dot(ca, cb);
	const double sin2 = cross(db, da), cos2 = dot(db, da);
	const double scale = dot(ca, ca) * dot(db, db) + dot(cb, cb) * dot(da, da);
	return sin1 * cos2 + cos1 * sin2 >= -onCircleTolerance * scale;
}

void PolygonDelaunay::makeDelaunay(HolePatch& patch) const
{
	const int edges     = int(patch.corner.size());
	int       flipsLeft = maxFlipsFactor * edges * edges;
	for (bool again = true; again;) {
		again = false;
		for (int x = 0; x < edges; ++x) {
			if (patch.across[x] <= x || isDelaunay(patch, x)) continue;
			const int c = patch.corner[prevInFace(x)];
			const int d = patch.corner[prevInFace(patch.across[x])];
			if (isForbidden(c, d)) continue;
			if (flipsLeft-- == 0) return;
			flipDiagonal(patch, x);
			again = true;
		}
	}
}

} // namespace gpr
