// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_REPORT_REMESH_OUTCOME_H
#define VCG_EXTRAS_APPS_GPREMESH_REPORT_REMESH_OUTCOME_H

#include <vcg_extras/core/remesh.h>
#include <vcg_extras/io/base/exit_code.h>

#include <string>

namespace gpr::app {

/// The sentence for a run without a result.
std::string sentenceOf(const Outcome& outcome);

/// Throws AppError with the fitting exit code and sentence for a run without a result.
void requireDone(const Outcome& outcome);

} // namespace gpr::app

#endif
