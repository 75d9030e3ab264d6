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

#include <memory>

namespace gpr {

/// Turns faces that are inverted or lie across feature lines, by flips, moves on the surface and,
/// if vertices may go, collapses; only the exact count restores collapsed vertices. Components of
/// four faces that look inside are turned whole, by an exchange of two vertices. At degenerate
/// faces that resist all other repair, feature lines end. Returns false if the budget ended the
/// search. Cost: a pass over the faces, and the few bad faces.
bool repairInvertedFaces(const Surface& surface, const BoundaryCurves& curves, bool mayCollapse,
						 ResultMesh& result, Workers& workers);

/// Raises angles below angleDeg by moves on the surface and flips, for results without a fit, which
/// have no assigned points. Returns false if the budget ended the search. Cost: a pass over the
/// angles, and the few poor faces.
bool raiseAnglesOnSurface(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
						  ResultMesh& result, Workers& workers);

/// The goal of the repair after the fit.
struct PoorFaces {
	float       angleDeg = 32;  ///< no face shall have a smaller angle
	CountTarget target;         ///< count of the result; 0 vertices and faces: any number
	float       largestGap = 0; ///< between input and result, working units; 0: not known
	float       maxGap     = 0; ///< see Acceptance::gap, while angles are raised; 0: not limited
	/// Of the faces of the result; made by the repair if needed and null.
	std::unique_ptr<ClosestFaceMap> map;
};

// The repair after the fit, in two parts. Both need a mesh without dead faces, and return false if
// the budget ended a search, or if too many faces are poor for a search. Cost of both together:
// bounded by the budget, about a third of a second, and a tenth of the run on large meshes; the
// worst faces come first.

/// Raises small angles by moves and flips.
bool raiseSmallAngles(const Surface& surface, const BoundaryCurves& curves, PoorFaces& wanted,
					  ResultMesh& result, Workers& workers);

/// After raiseSmallAngles: raises the small angles that are left by splits and collapses,
/// compensated at other places, then by pairs of splits and collapses in a row. Last come large
/// angles (asPoorAs), by moves and flips that keep the limits of small angles. A change of the
/// count is kept only if the lack of angles shrinks, the smallest angle does not fall, the number
/// of inverted faces does not grow, and the count is reached.
bool repairPoorFaces(const Surface& surface, const BoundaryCurves& curves, PoorFaces& wanted,
					 ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
