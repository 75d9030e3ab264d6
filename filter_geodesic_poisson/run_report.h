// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_RUN_REPORT_H
#define FILTER_GEODESIC_POISSON_RUN_REPORT_H

#include <vcg_extras/core/remesh.h>

#include <string>
#include <vector>

namespace gpr_filter {

// The report of a finished run in MeshLab's log, one entry a line: notes, repairs, caps reached,
// counts before and after, seconds by stage.

/// before: of the mesh before the run.
std::vector<std::string> remeshingLines(const gpr::RemeshResult&   result,
										const gpr::QualityFigures& before);
std::vector<std::string> samplingLines(const gpr::SamplingResult& result);
std::vector<std::string> featureLines(const gpr::FeatureResult& result);
/// Also the number of samples off the surface and their distance, and the use of all samples.
std::vector<std::string> retriangulationLines(const gpr::RemeshResult& result);

} // namespace gpr_filter

#endif
