// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_IMPROVEMENT_H
#define VCG_EXTRAS_CORE_RUN_IMPROVEMENT_H

#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Edge flips, in so many passes at most as the options say.
void flipEdges(RunContext& run, ResultMesh& result);

/// Makes the triangles regular on the surface, by the smoothing and the regularity chosen; last the
/// inverted faces are repaired.
void improve(RunContext& run, const Prepared& p, const BoundaryCurves& boundary,
			 ResultMesh& result);

/// Whether the largest distance from the input is what the user asked for.
enum class LargestDistance { Counts, IsOneOfMany };

/// The last to move vertices: those before walk on the surface, which this leaves. Feature lines
/// that are too close to each other for good angles are released, and all begins anew. Last of all
/// the worst angles once more, with or without a fit. Where the largest distance counts, or sizes
/// follow the error, the fit sees to that too. Returns what was found of faces that touch.
KnownContacts fitResult(RunContext& run, const Prepared& p, const BoundaryCurves& boundary,
						LargestDistance largest, ResultMesh& result);

} // namespace gpr

#endif
