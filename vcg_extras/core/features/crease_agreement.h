// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CREASE_AGREEMENT_H
#define VCG_EXTRAS_CORE_FEATURES_CREASE_AGREEMENT_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Cosine of the angle between the face of half-edge h, which lies on a feature line, and the
/// input's face on that side of the line, halfway between the ends of h. 1 where h lies on no
/// feature line, or between two vertices that never move along one.
float creaseAgreement(const Surface& surface, const BoundaryCurves& curves,
					  const ResultMesh& result, int h);

} // namespace gpr

#endif
