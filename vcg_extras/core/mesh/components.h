// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_COMPONENTS_H
#define VCG_EXTRAS_CORE_MESH_COMPONENTS_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <vector>

namespace gpr {

/// Which faces are linked over edges.
struct Components {
	int              num = 0;
	std::vector<int> ofFace; ///< per face: the number of its component, in the order of their first
							 ///< faces
};

/// Of a mesh without dead faces. Cost: linear, serial; polls.
Components findComponents(const HalfEdgeMesh& mesh, Workers& workers);

} // namespace gpr

#endif
