// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_WELD_H
#define VCG_EXTRAS_APPS_GPREMESH_WELD_H

#include "mesh_data.h"

namespace gpr::app {

/// Makes one vertex of all that lie at exactly the same position (-0 equals 0), in the order of
/// their first use. For formats that store corners, not vertices. Linear in time.
void weldEqualPositions(InputMesh& mesh);

} // namespace gpr::app

#endif
