// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_ANGLE_MENDING_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_ANGLE_MENDING_H

#include "patch_mover.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/cells.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <memory>

namespace gpr {

/// After stage 12: raises angles below `angleDeg` that the passes before left, most of them where
/// the surface is not flat. Round each such triangle, the sharpest first, vertices move along the
/// surface, those of curves along these, and edges are flipped, alone or together with moves of the
/// vertices round them, as long as that lowers the sum of the squares of what the angles round
/// there lack, then of their fourth powers, then of the squares again. Vertices keep their height
/// above the surface; corners of curves, tips and pinned ones stay altogether. A change is refused
/// if it takes the vertices of the input that belong to the faces round it further from them than
/// 5 % of an edge and than before, or makes a face agree less with the surface's normals. Where
/// largestGap, the largest distance between input and result (working units), is known, vertices of
/// the input that are more than .7 times as far off must not get farther, by the sum of the fourth
/// powers: without that one tip could be cut off because its neighbour is.
/// What makes faces cross is withdrawn: all is done again without the vertices concerned, a few
/// times, then not at all.
///
/// Nothing is done where more than 500 triangles and 1 % of all are poor. Returns false if all was
/// withdrawn, or if there were too many tries: 2000, and one for each 2000 triangles. Needs a mesh
/// without dead faces; `cells` are those of its faces, and are found here where they are needed and
/// null. Cost: a pass over the angles; where some are poor the few faces concerned, the boxes of a
/// search for crossing faces, and one finding of cells unless they are given.
bool mendAngles(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
				ResultMesh& result, Workers& workers, std::unique_ptr<Cells>& cells,
				float largestGap = 0);
bool mendAngles(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
				ResultMesh& result, Workers& workers);

/// The same with cells that were found for an earlier state of the mesh.
bool mendAngles(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
				ResultMesh& result, Workers& workers, const CellsOfFaces& cells);

} // namespace gpr

#endif
