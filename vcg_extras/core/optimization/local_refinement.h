// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_LOCAL_REFINEMENT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_LOCAL_REFINEMENT_H

#include "worst_distances.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/edit/acceptance.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

struct LocalRefinement {
	float minAngle = 0; ///< radians; smaller angles beside new vertices are raised
	float maxGap   = 0; ///< largest distance of a face from the surface after that, working units
	int   mostNew  = 0; ///< vertices; if more are needed, nothing is changed
	/// Of the tests for contacts; after that no edge is split.
	std::int64_t mostWork = workOf(Driver::Refinement);
};

/// Makes triangles smaller at given points: for each point, splits an edge of the nearest face of
/// the result. The edge is a feature or border edge if the point lies beside such an edge, else the
/// longest edge of the face. The new vertex goes to the far point of the surface, or to the surface
/// point nearest to a far point of the result; if faces would then be inverted or intersect other
/// faces, the vertex goes to the middle of the edge. Then moves and flips raise small angles, and
/// the largest distances are lowered (worst_distances.h). The rest of the mesh does not change.
/// Needs a result without dead faces. Returns the number of new vertices. Cost: a closest-face map,
/// a tree over the faces, a search in the tree for each point, and the few poor faces.
int refineAt(const Surface& surface, const BoundaryCurves& curves,
			 const std::vector<FarPoint>& points, const LocalRefinement& settings,
			 ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
