// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_POLYGON_DELAUNAY_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_POLYGON_DELAUNAY_H

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <utility>
#include <vector>

namespace gpr {

/// Point of the plane.
struct Vec2d {
	double x = 0, y = 0;
};

/// Constrained Delaunay triangulation of a small polygon: its edges are the constraints, no point
/// is added. Keeps its working memory from call to call.
///
/// Method: ears are cut off (Meisters 1975), then diagonals flipped until each is locally Delaunay
/// (Lawson 1977; Lee & Lin 1986 for the constrained case). Works in double; three points count as
/// in line where twice their area is below 1e-9 of the squared length of the longest edge, four as
/// on a circle where the sine of the sum of opposite angles is below 1e-9.
class PolygonDelaunay {
public:
	/// Pairs of corners that no diagonal may join; kept until changed.
	std::vector<std::pair<int, int>> forbidden;

	/// Triangulates the polygon, corners counter-clockwise, into patch. False if there is no way to
	/// go on that the tolerance and the forbidden diagonals allow, as where the polygon is not
	/// simple. Cost: quadratic in the number of corners at worst, for ears; flips are few.
	bool triangulate(const std::vector<Vec2d>& polygon, HolePatch& patch);

private:
	/// The rest of the polygon while ears are cut off: a ring of corners.
	struct Corner {
		int  before, after;
		int  beyond; ///< of the edge to the next corner: as in HolePatch::across
		bool isReflex;
	};

	const Vec2d*        p_      = nullptr;
	double              inLine_ = 0; ///< twice the area below which three points are in line
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
