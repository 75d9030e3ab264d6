// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_MESHING_H
#define VCG_EXTRAS_CORE_RUN_MESHING_H

#include "detection.h"
#include "prepared.h"
#include "sample_stages.h"

#include <vcg_extras/core/base/run_context.h>

namespace gpr {

/// A mesh, and the surface that it was made from.
struct MeshedSurface {
	Prepared prepared;
	Meshed   meshed;
};

/// Meshes the surface for its target, as often as it takes until a verdict accepts the mesh
/// (verdict.h); the target is then the count that was reached. The triangles are regular, but not
/// fitted to the input yet. Throws Failure where no mesh may be accepted.
MeshedSurface meshForTarget(RunContext& run, const FeatureMarks& marks, Prepared prepared);

} // namespace gpr

#endif
