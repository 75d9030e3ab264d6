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

/// A result of which some patches have been replaced by the input's own triangles there.
struct RefilledMesh {
	std::unique_ptr<GuardedMesh> guarded;      ///< all but the vertices inside patches are fixed
	std::vector<int>             resultVertex; ///< per vertex: the result's; -1 inside patches
	std::vector<int> inputVertex; ///< per vertex: the input's that it is or lies near; -1 outside
	std::vector<int> label;       ///< per vertex: the result's in whose place, or at whose, it is
	double           work = 0;    ///< vertices of the input that were looked at, in all rounds
};

/// Whether marks that have grown may grow on.
using HasRoom = std::function<bool(const std::vector<char>& marked)>;

/// Takes the marked faces out of a result and puts the input's triangles in their place, so that
/// the mesh is whole again and of the same topology. Every vertex of the input near a patch belongs
/// to the vertex of the result that has the largest weight at the nearest point of the result's
/// triangles. Those that belong to vertices inside the patch stay, those that belong to a vertex of
/// its border are drawn together to that: where the input is finer than the result that leaves
/// triangles between the two that close the gap exactly. So the input's edges are first split to a
/// third of the result's. Where that fails, as a cell on the border is no disk, meets its
/// neighbours otherwise than the triangles do or reaches farther than an edge, faces there are
/// marked too, and it begins again. Inside of patches the input is looked for farther away first.
///
/// Returns false where the marks do not settle, or where a border that others share with it would
/// have to change, or as soon as hasRoom says that the marks have grown too far. keptInput:
/// vertices of the input that are to be fixed, ascending. Serial. Cost: that of the
/// patches, times the rounds, and one pass over the result's and the input's vertices.
bool refillPatches(const Surface& surface, const ResultMesh& result,
				   const std::vector<int>& keptInput, std::vector<char>& marked, Workers& workers,
				   RefilledMesh& refilled, const HasRoom& hasRoom = {});

/// Marks the faces at the vertices of marked faces, so many times.
void widenMarks(const HalfEdgeMesh& mesh, int rings, std::vector<char>& marked);

} // namespace gpr

#endif
