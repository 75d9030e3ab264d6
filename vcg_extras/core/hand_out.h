// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_HAND_OUT_H
#define VCG_EXTRAS_CORE_HAND_OUT_H

#include "prepared.h"
#include "remesh.h"
#include "result_mesh.h"

namespace gpr {

/// The last stages: checks the result, tells about it and hands it out in the caller's terms.
/// Throws Failure where the audit fails.
void handOut(RunContext& run, const Prepared& p, const ResultMesh& result, RemeshResult& out);

} // namespace gpr

#endif
