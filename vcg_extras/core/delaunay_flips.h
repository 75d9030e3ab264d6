// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_DELAUNAY_FLIPS_H
#define VCG_EXTRAS_CORE_DELAUNAY_FLIPS_H

#include "result_mesh.h"
#include "workers.h"

namespace gpr {

/// Flips edges whose opposite angles add up to more than 180°, until none is left. An edge stays
/// where the flip would fold the surface, sharpen a crease, leave a vertex with two faces or double
/// an edge; edges of the border and of feature lines always stay. Returns the number of flips.
/// Cost: linear; edges are tested in parallel, the few that flip are turned serially.
std::int64_t flipToDelaunay(ResultMesh& result, Workers& workers);

/// Whether the faces that flipping h would make are sound: not turned over, no angle below
/// leastAngle (radians), no dihedral below leastCosine.
bool flipKeepsShape(const HalfEdgeMesh& m, int h, float leastAngle, float leastCosine);

} // namespace gpr

#endif
