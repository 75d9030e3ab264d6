// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_SMALL_COMPONENTS_H
#define VCG_EXTRAS_CORE_INPUT_SMALL_COMPONENTS_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Components with too few faces.
struct SmallComponents {
	std::int64_t     num = 0;
	std::vector<int> faces; ///< of all such components, ascending
};

/// Components (faces linked over edges) with fewer than minFaceNum faces. Cost: linear, serial.
SmallComponents findSmallComponents(const HalfEdgeMesh& mesh, std::int64_t minFaceNum,
									Workers& workers);

} // namespace gpr

#endif
