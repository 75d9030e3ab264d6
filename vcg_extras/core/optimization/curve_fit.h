// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_CURVE_FIT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_CURVE_FIT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// The measure to minimise. On an arc the mean distance is smallest with equal areas on both sides;
/// the largest distance is smallest after three quarters of the same move.
enum class CurveFit { MeanAndLargest, Mean };

/// First part of Stage::Fit: moves vertices of borders and feature lines off their curves, so that
/// the polygon of result edges lies closest to the curve by the mean of squared distances along the
/// curve. With vertices on a bent curve, the whole curve lies on one side of the polygon: the
/// largest distance of a chord is then twice the smallest possible distance.
///
/// Each vertex in sequence moves towards its own minimum, in four rounds. A move stands, whole,
/// halved or quartered, if the largest distance between the curve and the two edges there does not
/// grow (CurveFit::MeanAndLargest), if the vertex stays within 8 % of an edge from the curve, and
/// if no face turns or gets a smaller angle than minAngle (radians, or than the face had). Nodes,
/// corners and pinned vertices stay.
///
/// Changes mesh.position, and the records, which slide along the curve below the vertices. Cost:
/// the points of the curves and the rings of their vertices; serial.
void fitCurves(const Surface& surface, const BoundaryCurves& curves, float minAngle, CurveFit goal,
			   ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
