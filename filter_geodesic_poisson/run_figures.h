// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_RUN_FIGURES_H
#define FILTER_GEODESIC_POISSON_RUN_FIGURES_H

#include <vcg_extras/core/remesh.h>

#include <map>
#include <string>

namespace gpr_filter {

/// Names are public, since PyMeshLab exports these names: a change needs a changelog line. Lengths
/// are in mesh units, angles in degrees.
using Figures = std::map<std::string, double>;

// The figures of a finished run for programs; run_report.h has the same for people.

Figures remeshingFigures(const gpr::RemeshResult& result);
Figures samplingFigures(const gpr::SamplingResult& result);
Figures featureFigures(const gpr::FeatureResult& result);

} // namespace gpr_filter

#endif
