// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_DETECTION_H
#define VCG_EXTRAS_CORE_RUN_DETECTION_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/feature_detection.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// A surface and the features that were found on it.
struct DetectedFeatures {
	Surface      surface;
	FeatureEdges features;
};

/// Finds the features on the caller's own mesh, before any edge is split.
DetectedFeatures detectOnInput(RunContext& run);

/// Per vertex of the caller's: VertexFeature bits; empty: no vertex is marked.
using FeatureMarks = std::vector<std::uint8_t>;

/// The features for the feature region where the options ask for them, the same that detectFeatures
/// finds; else none.
FeatureMarks detectRegion(RunContext& run);

} // namespace gpr

#endif
