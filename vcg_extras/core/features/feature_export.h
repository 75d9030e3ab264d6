// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_FEATURE_EXPORT_H
#define VCG_EXTRAS_CORE_FEATURES_FEATURE_EXPORT_H

#include "feature_detection.h"

#include <vcg_extras/core/results.h>

namespace gpr {

/// Puts what was found on the working surface into the numbering of the caller's mesh. Where
/// cleaning made several vertices of one of the caller's, or one of several, strengths are the
/// largest of all and marks are joined. The surface must have whole faces of the caller's, not
/// split ones. Cost: linear, serial.
void exportFeatures(const MeshView& input, const Surface& surface, const FeatureEdges& features,
					FeatureResult& out);

} // namespace gpr

#endif
