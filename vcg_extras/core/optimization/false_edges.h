// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_FALSE_EDGES_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_FALSE_EDGES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Splits the edges inside of sheets that would become one with an edge of another sheet when they
/// are joined (see Junctions::falseEdges): such an edge would be a junction that the input has not.
/// Returns how many there were. Cost: that of Junctions.
int splitFalseEdges(const Surface& surface, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
