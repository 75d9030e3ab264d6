// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_SMOOTH_BORDER_H
#define VCG_EXTRAS_CORE_FEATURES_SMOOTH_BORDER_H

#include <vcg_extras/core/surface/curve.h>

#include <vector>

namespace gpr {

/// How far the vertices of a smooth border may lie from the border that they stand for, in wanted
/// edges (BoundaryMode::Smooth).
constexpr float borderSlack = 0.5f;

/// Takes what is shorter than about two wanted edges out of a closed curve: every point goes to a
/// mean of the curve round it, but no farther from the curve than seven tenths of the slack. Arc
/// lengths are those of the smooth curve then. Points marked as fixed stay, and within an edge of
/// them the curve comes back to what it was. edge: wanted where the size is 1. Cost: linear in the
/// curve's points and in its length over the smallest edge.
void smoothLoop(float edge, const std::vector<char>& isFixed, Curve& loop);

} // namespace gpr

#endif
