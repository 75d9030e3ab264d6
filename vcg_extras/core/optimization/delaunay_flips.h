// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_DELAUNAY_FLIPS_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_DELAUNAY_FLIPS_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// So many passes of flips stand for as many as it takes.
constexpr int untilDelaunay = 1000;

/// Flips edges whose opposite angles add up to more than 180°, until none is left. An edge stays
/// where the flip would fold the surface, leave a vertex with two faces or double an edge; edges of
/// the border and of feature lines always stay. With fewer than untilDelaunay passes (the paper's
/// user-given number) each pass flips those edges once that ask for it at its start. Returns the
/// number of flips. Cost: linear a pass; edges are tested in parallel, the few that flip are turned
/// serially.
std::int64_t flipToDelaunay(ResultMesh& result, Workers& workers, int maxPasses = untilDelaunay);

} // namespace gpr

#endif
