// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_FALSE_EDGES_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_FALSE_EDGES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Splits inner edges of sheets that would coincide with an edge of another sheet after joining
/// (see Junctions::falseEdges); the joined edge would be a junction without counterpart in the
/// input. Returns the number of split edges. Cost: the same as Junctions.
int splitFalseEdges(const Surface& surface, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
