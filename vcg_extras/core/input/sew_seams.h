// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_SEW_SEAMS_H
#define VCG_EXTRAS_CORE_INPUT_SEW_SEAMS_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Faces at a smaller angle, seen from their common edge, lie on each other: sheets, not a seam.
constexpr float leastSeamAngleDeg = 1;

/// Joins the mesh along its seams: exactly two border edges at the same place (ends within
/// samePlace) become one edge. Vertices at the same place are joined through such an edge only, and
/// never if an edge would get more than two faces. Edges stay cut if more than two lie at the same
/// place, if their faces lie on each other (a sheet with two sides), or if both run in the same
/// direction and turning whole parts of the mesh does not help. Such edges are counted, and their
/// ends get equal coordinates. Parts to turn over are left for repairManifold. Faces keep their
/// order and their sources; the vertices of a face move by at most samePlace.
///
/// Needs: no vertex twice in a face. Cost: two parallel passes over the faces; O(B log B) for B
/// border edges; O(F log F), serial, if edges run in the same direction.
void sewSeams(IndexedMesh& mesh, Workers& workers, CleanCounts& counts);

/// Whether two border vertices of a connected surface lie at the same place, so that there may be
/// seams. Cost: a parallel pass over the vertices, and a look at the border vertices.
bool mayHaveSeams(const Surface& surface, Workers& workers);

} // namespace gpr

#endif
