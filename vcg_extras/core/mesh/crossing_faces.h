// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_CROSSING_FACES_H
#define VCG_EXTRAS_CORE_MESH_CROSSING_FACES_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <vector>

namespace gpr {

/// Faces that an edge of another face, or one of whose edges another face, crosses; ascending.
/// Faces that share an edge are not compared, of those that share a vertex the edges opposite to
/// it. Touching and overlapping in one plane are not crossing. Needs a mesh without dead faces.
/// Cost: O(F log F), parallel, with a tree of boxes that is thrown away.
std::vector<int> findCrossingFaces(const HalfEdgeMesh& mesh, Workers& workers);

/// Only pairs of which at least one face is wanted (1 of a mark per face): both are in the answer.
std::vector<int> findCrossingFaces(const HalfEdgeMesh& mesh, const std::vector<char>& wanted,
								   Workers& workers);

/// The same with those that are wanted in a list.
std::vector<int> findCrossingFaces(const HalfEdgeMesh& mesh, const std::vector<int>& wanted,
								   Workers& workers);

/// Living faces whose boxes lie within `margin` of the box round some others; ascending. Cost:
/// O(F), parallel.
std::vector<int> facesNear(const HalfEdgeMesh& mesh, const std::vector<int>& faces, float margin,
						   Workers& workers);

/// Number of crossing pairs of which one is among `faces` and the other there or in `near`, both
/// ascending; dead faces are passed over. Cost: the product of the two.
int countCrossingPairs(const HalfEdgeMesh& mesh, const std::vector<int>& faces,
					   const std::vector<int>& near);

/// The same with all faces near. Cost: O(F), parallel.
int countCrossingPairs(const HalfEdgeMesh& mesh, const std::vector<int>& faces, Workers& workers);

} // namespace gpr

#endif
