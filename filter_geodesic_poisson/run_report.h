// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_RUN_REPORT_H
#define FILTER_GEODESIC_POISSON_RUN_REPORT_H

#include <string>
#include <vcg_extras/core/remesh.h>
#include <vector>

namespace gpr_filter {

/// What a finished run tells in MeshLab's log: notes, counts before and after, what was cleaned,
/// radius and seed, quality, audit, seconds by stage. One entry a line.
std::vector<std::string> logLines(const gpr::RemeshResult& result);

} // namespace gpr_filter

#endif
