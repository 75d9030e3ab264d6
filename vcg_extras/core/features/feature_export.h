// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_FEATURE_EXPORT_H
#define VCG_EXTRAS_CORE_FEATURES_FEATURE_EXPORT_H

#include "feature_detection.h"

#include <vcg_extras/core/results.h>

namespace gpr {

/// Converts the features of the working surface to the numbering of the input mesh. If repair
/// joined or doubled vertices, the largest strength counts and marks are joined. The surface must
/// have whole input faces, not split faces. Cost: linear, serial.
void exportFeatures(const MeshView& input, const Surface& surface, const FeatureEdges& features,
					FeatureResult& out);

} // namespace gpr

#endif
