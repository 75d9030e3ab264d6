// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_COMPARISON_REPORT_H
#define FILTER_GEODESIC_POISSON_COMPARISON_REPORT_H

#include "comparison.h"
#include "run_figures.h"

#include <string>
#include <vector>

namespace gpr_filter {

/// For the log: the compared meshes, a table with a line for each figure and a column for the input
/// and each result, and the topology if changed.
std::vector<std::string> comparisonLines(const Comparison& comparison);

/// For programs: the figures of remeshing, and after "quadric_" the figures of Quadric Edge
/// Collapse.
Figures comparisonFigures(const Comparison& comparison);

} // namespace gpr_filter

#endif
