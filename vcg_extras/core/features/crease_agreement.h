// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CREASE_AGREEMENT_H
#define VCG_EXTRAS_CORE_FEATURES_CREASE_AGREEMENT_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Normal agreement of the face of half-edge h on a feature line: the cosine of the angle to the
/// face of the working surface on the same side of the line, halfway between the ends of h. 1 if h
/// is on no feature line, or if neither end can slide along a line.
float creaseAgreement(const Surface& surface, const BoundaryCurves& curves,
					  const ResultMesh& result, int h);

} // namespace gpr

#endif
