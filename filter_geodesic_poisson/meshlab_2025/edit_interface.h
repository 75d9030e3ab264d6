// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_EDIT_INTERFACE_H
#define FILTER_GEODESIC_POISSON_EDIT_INTERFACE_H

// The interface of MeshLab 2025.07 to edit tools.

#include <common/plugins/interfaces/edit_plugin.h>

#define GPR_EDIT_PLUGIN EditPlugin
#define GPR_EDIT_PLUGIN_IID EDIT_PLUGIN_IID

namespace gpr_filter {

using ::EditPlugin;
using ::EditTool;

} // namespace gpr_filter

#endif
