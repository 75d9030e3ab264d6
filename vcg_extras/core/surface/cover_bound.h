// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_COVER_BOUND_H
#define VCG_EXTRAS_CORE_SURFACE_COVER_BOUND_H

#include "triangle_tree.h"

namespace gpr {

/// A proven bound of the distance of every point of a triangle, the piece, from a surface of many
/// smaller triangles.
///
/// The search follows the surface from the triangle `start` over every edge that lies above or
/// below the piece, seen along the piece's normal. The border of the reached part then lies beside
/// the piece. So all points of the piece have the same number of reached triangles above or below,
/// modulo two (the degree of the projection). If this number is odd at one point, every point of
/// the piece has a point of the surface right above or below. The bound is the largest height of
/// the surface over the piece.
///
/// Returns the bound, or infinity without a proof: if the bound would exceed limit, the surface has
/// a border or an edge of more than two triangles over the piece, more than maxTriangles (192)
/// triangles lie there, or the piece is a needle. rounding: a length, the error of coordinates.
/// Rounding makes the bound wrong by less than 1e-8 of the piece. Cost: linear in the triangles
/// over the piece.
double coverBound(const Triangle& piece, const TriangleTree& surface, int start, double limit,
				  double rounding);

} // namespace gpr

#endif
