// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_RUN_REPORT_H
#define FILTER_GEODESIC_POISSON_RUN_REPORT_H

#include <vcg_extras/core/remesh.h>

#include <string>
#include <vector>

namespace gpr_filter {

// What a finished run tells in MeshLab's log, one entry a line: notes, what was cleaned, bounds
// reached, what came out of what, seconds by stage.

/// before: of the mesh as it was.
std::vector<std::string> remeshingLines(const gpr::RemeshResult&   result,
										const gpr::QualityFigures& before);
std::vector<std::string> samplingLines(const gpr::SamplingResult& result);
std::vector<std::string> featureLines(const gpr::FeatureResult& result);
/// Also how many samples were off the surface and how far, and what became of all of them.
std::vector<std::string> retriangulationLines(const gpr::RemeshResult& result);

} // namespace gpr_filter

#endif
