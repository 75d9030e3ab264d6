// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_CROSSING_FACES_H
#define VCG_EXTRAS_CORE_CROSSING_FACES_H

#include "half_edge_mesh.h"
#include "workers.h"

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

/// Number of crossing pairs of which at least one is among `faces`, ascending; dead faces are
/// passed over. For few faces: cost O(F), and O(F) once more for what lies near them.
int countCrossingPairs(const HalfEdgeMesh& mesh, const std::vector<int>& faces);

} // namespace gpr

#endif
