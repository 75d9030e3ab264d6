// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_REFILL_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_REFILL_H

#include "guarded_decimation.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <functional>
#include <memory>
#include <vector>

namespace gpr {

/// A result with some patches replaced by the triangles of the working surface.
struct RefilledMesh {
	std::unique_ptr<GuardedMesh> guarded;      ///< all vertices outside of patches are fixed
	std::vector<int>             resultVertex; ///< per vertex: vertex of the result; -1 inside
											   ///< patches
	std::vector<int> inputVertex; ///< per vertex: vertex of the working surface, the same or near;
								  ///< -1 outside
	std::vector<int> label;       ///< per vertex: vertex of the result, the same or near
	double           work = 0;    ///< looks at vertices of the working surface, in all rounds;
								  ///< less than one look a vertex in rounds that collect nothing
};

/// Whether grown marks may grow further.
using HasRoom = std::function<bool(const std::vector<char>& marked)>;

/// Replaces the marked faces of a result by the triangles of the working surface, without gaps and
/// with the same topology. Every surface vertex near a patch belongs to a vertex of the result: the
/// corner with the largest weight at the nearest point of the result. If this corner lies inside of
/// the patch, the surface vertex stays. If the corner lies on the patch's border, the surface
/// vertex is merged into the corner; on a surface finer than the result the triangles between two
/// such cells close the gap exactly. So edges of the surface are first split to .4 of the
/// result's edges. If a border cell is no disk, meets its neighbours otherwise than the triangles
/// do or reaches farther than an edge, faces at the cell are marked too, and another round begins.
/// The surface is collected with some more rings, and serves until a patch leaves it.
/// Inside of patches the search distance grows first.
///
/// Returns false if the marks do not settle, if a border shared with other borders would have to
/// change, or when hasRoom returns false. keptInput: vertices of the working surface to fix,
/// ascending. Serial. Cost: linear in the patches, times the rounds, and a pass over the vertices
/// of result and working surface.
bool refillPatches(const Surface& surface, const ResultMesh& result,
				   const std::vector<int>& keptInput, std::vector<char>& marked, Workers& workers,
				   RefilledMesh& refilled, const HasRoom& hasRoom = {});

} // namespace gpr

#endif
