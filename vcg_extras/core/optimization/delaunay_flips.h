// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_DELAUNAY_FLIPS_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_DELAUNAY_FLIPS_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// The number of passes that means: flip until all edges are Delaunay.
constexpr int untilDelaunay = 1000;

/// Flips edges with opposite angles of more than 180° in total, until no such edge is left. An edge
/// stays if the flip would fold the surface, leave a vertex with two faces or double an edge; edges
/// of borders and feature lines always stay. With fewer than untilDelaunay passes (the number given
/// by the user in the paper), a pass flips only the edges found at the start of the pass. Returns
/// the number of flips. Cost: linear per pass; tests in parallel, the few flips serially.
std::int64_t flipToDelaunay(ResultMesh& result, Workers& workers, int maxPasses = untilDelaunay);

} // namespace gpr

#endif
