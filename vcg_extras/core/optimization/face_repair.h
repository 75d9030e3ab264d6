// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_FACE_REPAIR_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_FACE_REPAIR_H

#include "exact_count.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/closest_face_map.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <memory>

namespace gpr {

/// Turns faces that are inverted or lie across feature lines, by flips, moves on the
/// surface and, where vertices may go, collapses; only the exact count makes these good again.
/// Components of four faces that look inside are turned whole, by an exchange of two vertices.
/// Where nothing else helps a face without area, feature lines at it end. Returns false if the
/// budget ended the search. Cost: a pass over the faces, and the few bad ones.
bool repairInvertedFaces(const Surface& surface, const BoundaryCurves& curves, bool mayCollapse,
						 ResultMesh& result, Workers& workers);

/// Raises angles below angleDeg by moves on the surface and flips, where no fit follows that knows
/// what each face stands for. Returns false if the budget ended the search. Cost: a pass over the
/// angles, and the few poor faces.
bool raiseAnglesOnSurface(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
						  ResultMesh& result, Workers& workers);

/// What is to be repaired after the fit.
struct PoorFaces {
	float       angleDeg = 32;  ///< no face shall have a smaller angle
	CountTarget target;         ///< that the result must have; 0 vertices and faces: any number
	float       largestGap = 0; ///< between input and result, working units; 0: not known
	float       maxGap     = 0; ///< see Acceptance::gap, while angles are raised; 0: not limited
};

/// After the fit: raises small angles, by moves and flips, then by splits and collapses, which
/// other places make good, then by two of these in a row. Last come large angles (asPoorAs), by
/// moves and flips that leave no angle poorer than it may be. What changes the count is kept only
/// if angles lack less then, none is smaller than the smallest before, no more faces are inverted,
/// and the count is reached. Needs a mesh without dead faces; `map` belongs to its faces, and is
/// made here where it is needed and null. Returns false if the budget ended a search. Cost: bounded
/// by that budget, about a third of a second, and a tenth of the run on large meshes; the worst
/// faces come first.
bool repairPoorFaces(const Surface& surface, const BoundaryCurves& curves, const PoorFaces& wanted,
					 std::unique_ptr<ClosestFaceMap>& map, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
