// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_SMOOTH_BORDER_H
#define VCG_EXTRAS_CORE_FEATURES_SMOOTH_BORDER_H

#include <vcg_extras/core/surface/curve.h>

#include <vector>

namespace gpr {

/// The largest distance of a vertex on a smooth border from the border of the input, in wanted
/// edges (BoundaryMode::Smooth).
constexpr float borderSlack = 0.5f;

/// Smooths away details of a closed curve shorter than about two wanted edges. Every point moves to
/// a mean of the curve round it, but at most seven tenths of borderSlack off the curve. Arc lengths
/// are measured anew on the smooth curve. Fixed points stay, and within an edge of a fixed point
/// the curve returns to its old course. edge: the wanted edge at size 1. Cost: linear in the points
/// of the curve and in its length over the smallest edge.
void smoothLoop(float edge, const std::vector<char>& isFixed, Curve& loop);

} // namespace gpr

#endif
