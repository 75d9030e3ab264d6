// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_SEW_SEAMS_H
#define VCG_EXTRAS_CORE_INPUT_SEW_SEAMS_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Faces that meet at less than this, seen from their edge, lie on one another: sheets, not a seam.
constexpr float leastSeamAngleDeg = 1;

/// Joins the mesh along its seams: where exactly two edges of the border lie at the same place
/// (ends within samePlace), they become one edge. Vertices that lie at the same place are joined
/// through such an edge only, and never so that an edge gets more than two faces. Edges stay cut
/// where more than two of them lie at one place; where their faces lie on one another, as those of
/// a sheet with two sides do; and where they run in the same direction and turning over whole parts
/// of the mesh does not help. Those are counted, and their ends moved to the same numbers. Parts
/// that have to be turned over are left for repairManifold. Faces keep their order and their
/// sources; the vertices of a face move by no more than samePlace.
///
/// Needs: no vertex twice in a face. Cost: a pass over the faces that reads no vertex where the
/// mesh is closed; with borders two more that do, parallel, and O(B log B) for B edges of the
/// border; O(F log F), serial, where edges run in the same direction.
void sewSeams(IndexedMesh& mesh, Workers& workers, CleanCounts& counts);

/// Whether two vertices of a connected surface's border lie at one place, so that there may be
/// seams. Cost: a pass over the vertices, parallel, and the vertices of the border.
bool mayHaveSeams(const Surface& surface, Workers& workers);

} // namespace gpr

#endif
