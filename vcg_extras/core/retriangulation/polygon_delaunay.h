// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_POLYGON_DELAUNAY_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_POLYGON_DELAUNAY_H

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <utility>
#include <vector>

namespace gpr {

/// Constrained Delaunay triangulation of a small polygon. The edges of the polygon are the
/// constraints; no point is added. Keeps its working memory between calls.
///
/// Method: cuts ears off (Meisters 1975), then flips diagonals until each is locally Delaunay
/// (Lawson 1977; Lee & Lin 1986 for the constrained case). Works in double. Three points count as
/// collinear if twice their area is below 1e-9 of the squared longest edge; four points count as on
/// a circle if the sine of the sum of opposite angles is below 1e-9.
class PolygonDelaunay {
public:
	/// Pairs of corners that no diagonal may join; kept until changed.
	std::vector<std::pair<int, int>> forbidden;

	/// Triangulates a polygon with counter-clockwise corners into `patch`. Returns false if
	/// tolerance and forbidden diagonals leave no way, as for a polygon that is not simple. Cost:
	/// for ears at worst quadratic in the number of corners; flips are few.
	bool triangulate(const std::vector<Vec2d>& polygon, HolePatch& patch);

private:
	/// A corner of the polygon's rest after some ears were cut off; the corners form a ring.
	struct Corner {
		int  before, after;
		int  beyond; ///< beyond the edge to the next corner: as in HolePatch::across
		bool isReflex;
	};

	const Vec2d*        p_      = nullptr;
	double              inLine_ = 0; ///< twice the area below which three points are collinear
	std::vector<Corner> corner_;

	void   begin(const std::vector<Vec2d>& polygon);
	bool   cutEars(HolePatch& patch);
	void   cutEar(int i, HolePatch& patch);
	bool   isEar(int i) const;
	bool   isForbidden(int i, int j) const;
	void   classify(int i);
	double turn(int i, int j, int k) const;
	bool   isDelaunay(const HolePatch& patch, int x) const;
	void   makeDelaunay(HolePatch& patch) const;
};

} // namespace gpr

#endif
