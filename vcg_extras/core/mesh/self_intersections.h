// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_SELF_INTERSECTIONS_H
#define VCG_EXTRAS_CORE_MESH_SELF_INTERSECTIONS_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Self-intersecting faces, ascending: an edge of one passes through another.
/// Faces that share an edge are not compared, of those that share a vertex the edges opposite to
/// it. Touching and overlapping in one plane are no intersection. Needs a mesh without dead faces.
/// Cost: O(F log F), parallel, with a tree of boxes that is thrown away.
std::vector<int> findIntersectingFaces(const HalfEdgeMesh& mesh, Workers& workers);

/// Number of intersecting pairs of which one is among `faces` and the other there or in `near`,
/// both ascending; dead faces are passed over. Adds the number of pairs that were compared to
/// `work`, if it is given. Cost: the product of the two for the boxes of the faces.
int countIntersectingPairs(const HalfEdgeMesh& mesh, const std::vector<int>& faces,
						   const std::vector<int>& near, std::int64_t* work = nullptr);

} // namespace gpr

#endif
