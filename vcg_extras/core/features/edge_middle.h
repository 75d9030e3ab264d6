// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_EDGE_MIDDLE_H
#define VCG_EXTRAS_CORE_FEATURES_EDGE_MIDDLE_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Sets `middle` to a point of the surface halfway between the vertices a and b, by walking from
/// the one of them that lies on no feature line. False where no walk ends well between them.
bool findMiddle(const Surface& surface, const ResultMesh& result, int a, int b,
				ResultVertex& middle);

/// The same for neighbours on a curve: a point of that halfway between them. False where neither of
/// them may slide along it.
bool findMiddleOnCurve(const Surface& surface, const BoundaryCurves& curves,
					   const ResultMesh& result, int a, int b, ResultVertex& middle);

} // namespace gpr

#endif
