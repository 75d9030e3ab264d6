// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_EDGE_MIDDLE_H
#define VCG_EXTRAS_CORE_FEATURES_EDGE_MIDDLE_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Sets `middle` to a point of the surface halfway between the vertices a and b. The walk starts at
/// a vertex on no feature line; if both lie on feature lines, every face at a is tried. False if no
/// walk ends near the middle.
bool findMiddle(const Surface& surface, const ResultMesh& result, int a, int b,
				ResultVertex& middle);

/// Sets `middle` to a point halfway between the neighbours a and b on a curve, along the curve.
/// False if neither may slide along the curve.
bool findMiddleOnCurve(const Surface& surface, const BoundaryCurves& curves,
					   const ResultMesh& result, int a, int b, ResultVertex& middle);

} // namespace gpr

#endif
