// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_POOR_FACES_H
#define VCG_EXTRAS_CORE_POOR_FACES_H

#include "half_edge_mesh.h"
#include "workers.h"

#include <vector>

namespace gpr {

/// Living faces with a smaller angle than this (radians, at most 60°), ascending. Cost: a few
/// products a face; the angle itself is only worked out where the edges leave it open.
std::vector<int> findPoorFaces(const HalfEdgeMesh& mesh, float angle, Workers& workers);
/// Those of the given faces.
std::vector<int> poorOnes(const HalfEdgeMesh& mesh, float angle, const std::vector<int>& faces);

} // namespace gpr

#endif
