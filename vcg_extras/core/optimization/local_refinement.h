// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_LOCAL_REFINEMENT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_LOCAL_REFINEMENT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// A point of the surface that is far from the result, or of the result that is far from the
/// surface; working units.
struct FarPoint {
	Vec3f position;
	float distance    = 0;
	bool  isOfSurface = false;
};

struct LocalRefinement {
	float minAngle = 0; ///< radians; angles beside new vertices are raised up to this
	float maxGap   = 0; ///< so far may a face be from the surface after that, working units
	int   mostNew  = 0; ///< vertices; where it would take more nothing is changed
};

/// Makes triangles smaller at some points: splits an edge of the face of the result that is nearest
/// to each. The edge is a feature or border edge if the point lies beside it, else the longest one
/// of the face. The new vertex goes to the point of the surface that is far, or that is nearest to
/// the point; where that would invert faces or let them intersect others, into the middle of the
/// edge. Then small angles are raised by moves and flips, and the largest distances are lowered
/// (worst_distances.h). All else stays as it is. Needs a result without dead faces. Returns the
/// number of vertices that came in. Cost: a closest-face map, a tree over the faces, a search in it
/// for each point, and the few poor faces.
int refineAt(const Surface& surface, const BoundaryCurves& curves,
			 const std::vector<FarPoint>& points, const LocalRefinement& settings,
			 ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
