// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_PREPARATION_H
#define VCG_EXTRAS_CORE_RUN_PREPARATION_H

#include "detection.h"
#include "loading.h"
#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>

#include <cstdint>

namespace gpr {

/// Everything before the feature lines: loads, cleans, splits, orders and connects the input, finds
/// target, sizes and feature region. `marks` are of the detected feature region.
Prepared prepare(RunContext& run, const FeatureMarks& marks);

/// The same for a count that is known.
Prepared prepareFor(RunContext& run, const FeatureMarks& marks, std::int64_t vertexNum,
					Sewing sewing = Sewing::NotYet);

} // namespace gpr

#endif
