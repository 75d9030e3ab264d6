// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_CREASE_SIDES_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_CREASE_SIDES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Cosine of the angle between the face of half-edge h, which lies on a feature line, and the
/// input's face on that side of the line, halfway between the ends of h. 1 where h lies on no
/// feature line, or between two vertices that never move along one.
float creaseAgreement(const Surface& surface, const BoundaryCurves& curves,
					  const ResultMesh& result, int h);

/// A triangle with two edges on a curved feature line can lie across it, as if to close a hole
/// with a piece of lid where the wall goes down: the edges are there, and no crease. Such faces, by
/// more than 60° off the input's beside the line, are turned to it by flipping one of their other
/// edges where that helps and makes no face cross another. Returns the number of flips. Cost: the
/// faces at feature lines.
int alignFacesAtCreases(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result,
						Workers& workers);

} // namespace gpr

#endif
