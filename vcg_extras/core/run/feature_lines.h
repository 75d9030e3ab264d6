// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_FEATURE_LINES_H
#define VCG_EXTRAS_CORE_RUN_FEATURE_LINES_H

#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/boundary_curves.h>

namespace gpr {

/// The paper's removal of vertices knows no curves but the border.
bool followsFeatureLines(const RemeshOptions& options);

/// Whether findFeatureLines will find lines by itself. The surface is as before.
bool hasFeatureLines(RunContext& run, Prepared& p);

/// Marks the feature lines; from here on the surface does not change any more. Where there are
/// more of them than the wanted vertices can follow, the shorter ones are left out, and where
/// one runs close beside another the weaker one. The caller's own lines are added where they leave
/// enough vertices to the surface between them.
void findFeatureLines(RunContext& run, Prepared& p);

void forgetFeatureLines(RunContext& run, Prepared& p);

/// Samples of border and feature lines for disks of that radius.
BoundaryCurves sampleCurves(const Prepared& p, float radius, BoundaryMode border);

} // namespace gpr

#endif
