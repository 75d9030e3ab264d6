// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_REPORT_SUMMARY_H
#define VCG_EXTRAS_APPS_GPREMESH_REPORT_SUMMARY_H

#include <vcg_extras/io/report/report_json.h>

namespace gpr::app {

/// The summary of a run for the user, some lines of text.
std::string remeshSummary(const RunRecord& run);

/// The figures of a mesh, some lines of text.
std::string meshInfoText(const MeshInfo& info);

} // namespace gpr::app

#endif
