// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_COVER_BOUND_H
#define VCG_EXTRAS_CORE_SURFACE_COVER_BOUND_H

#include "triangle_tree.h"

namespace gpr {

/// A proven bound of the distance of every point of a triangle from a surface of many small ones.
///
/// The surface is followed from the triangle `start` over every edge that lies above or below the
/// piece, seen along the piece's normal. What is reached has all its border beside the piece. So a
/// point of the piece that has an odd number of its triangles above or below it shares that with
/// all points of the piece: each has a point of the surface right above or below (the degree of the
/// projection, modulo two). The bound is the largest height of the surface over the piece.
///
/// Returns the bound, or infinity where there is no such proof: it would be above limit, the
/// surface has a border or an edge of more than two triangles over the piece, more than some
/// hundred triangles lie there, or the piece is a needle. `rounding` is a length within which
/// coordinates are exact. Rounding makes the bound wrong by less than 1e-8 of the piece. Cost:
/// linear in the triangles over the piece.
double coverBound(const Triangle& piece, const TriangleTree& surface, int start, double limit,
				  double rounding);

} // namespace gpr

#endif
