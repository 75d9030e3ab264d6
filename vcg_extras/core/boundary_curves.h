// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BOUNDARY_CURVES_H
#define VCG_EXTRAS_CORE_BOUNDARY_CURVES_H

#include "connect.h"
#include "curve.h"
#include "walk.h"

#include <vector>

namespace gpr {

/// A sample on a border curve: fixed in number, free to slide along its curve unless a corner.
struct CurveSample {
	Anchor anchor;
	int    curve    = -1;
	float  arc      = 0;
	bool   isCorner = false;
	int    vertex = -1; ///< the input vertex that stands for it in the removal; -1 if none is left
};

/// The border loops of the input, their samples, and which sample each border vertex belongs to.
struct BoundaryCurves {
	std::vector<Curve>       curves;
	std::vector<CurveSample> samples;
	/// For every vertex of curves[c], in order: the nearest sample along the arc.
	std::vector<std::vector<int>> sampleOfPoint;
};

/// Stage 5: samples the border before anything else, so that it keeps its shape and its triangles
/// are as regular as inside: loops are cut at corners (a turn of 50° that persists over r), each
/// piece is sampled by chords of `spacing` (see spaceOut). Loops too short for three samples keep
/// three of their own vertices. Cost: linear in the border.
BoundaryCurves sampleBoundary(const Surface& surface, float diskRadius, float spacing);

} // namespace gpr

#endif
