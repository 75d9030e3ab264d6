// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_PATCH_REMESHING_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_PATCH_REMESHING_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/cells.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace gpr {

/// What earlier passes left, as far as it is known.
struct LeftOver {
	float            largestGap = 0; ///< between result and input, working units
	std::vector<int> crossing;       ///< faces that cross others, or did before edges were flipped
};

/// After stage 12, for angles below `angleDeg` that moves and flips (angle_mending.h) cannot raise:
/// narrow strips between two curves, samples of a curve closer together than the triangles beside
/// it are wide, vertices with three faces. Of each such triangle, the sharpest first, every edge is
/// split and collapsed on trial, those of curves along these, then edges round it are flipped and
/// vertices moved; the trial that lowers most the sum of the squares of what the angles there lack
/// is kept. Where that helps no more and few such triangles are left, two changes in a row are
/// tried, the second one at the triangle that the first one leaves sharpest. Refused is what takes
/// the vertices of the input that belong there further away than 5 % of an edge and than before, or
/// on the mean than 2.5 % and than 1.3 times as far as before, what makes a face agree less with
/// the surface's normals, and what makes faces cross. largestGap: see angle_mending.h. Then the
/// same is done for faces that still cross others: kept is what leaves the fewest crossing pairs,
/// if it makes no angle poorer than the worst there and takes the surface no further away than a
/// tenth of an edge and than before.
///
/// The count is made good elsewhere, as in stage 9, if targetNum is above 0, and the angles there
/// are mended. Should angles then lack more than at first, the worst be worse, more faces look
/// against the surface, or the count not be reached, all is done again without pairs of changes,
/// and if that does not help either all is as it was, and the answer is false. Nothing is done
/// where no angle is poor and no face crosses another, or where more angles are poor than 100 and
/// 0.1 % of all. Needs a mesh without dead faces; `cells` are those of its faces before the call,
/// and are found here where they are needed and null. Cost: where angles are poor, some
/// milliseconds a triangle, for 200 triangles at most, and for pairs some fifty, for 12 at most.
bool remeshPoorPatches(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
					   std::int64_t targetNum, ResultMesh& result, Workers& workers,
					   std::unique_ptr<Cells>& cells, const LeftOver& left = {});

} // namespace gpr

#endif
