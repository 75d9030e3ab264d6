// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_CURVE_FIT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_CURVE_FIT_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// What gets smaller. On an arc the mean is least where both sides keep their areas; the largest
/// distance is least a quarter of the way before.
enum class CurveFit { MeanAndLargest, Mean };

/// First part of Stage::Fit: moves the vertices of borders and feature lines off their curves to
/// where the polygon of the result's edges lies closest to the curve, in the mean of squares along
/// it. Vertices on the curve leave all of it on one side where it bends: a chord's greatest
/// distance is twice the least that is possible.
///
/// One vertex after the other goes towards the minimum for it, four rounds of this. A move stands,
/// whole, halved or quartered, if the largest distance between the curve and the two edges there
/// does not grow (CurveFit::MeanAndLargest), if the vertex stays within 8 % of an edge from the
/// curve, and if no face turns or gets a smaller angle than minAngle (radians, or than it had).
/// Nodes, corners and pinned vertices stay.
///
/// Changes mesh.position, and the records, which slide along the curve below the vertices. Cost:
/// the points of the curves and the rings of their vertices; serial.
void fitCurves(const Surface& surface, const BoundaryCurves& curves, float minAngle, CurveFit goal,
			   ResultMesh& result);

} // namespace gpr

#endif
