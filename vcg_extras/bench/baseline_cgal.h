// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_BASELINE_CGAL_H
#define VCG_EXTRAS_BENCH_BASELINE_CGAL_H

#include <vcg_extras/apps/gpremesh/compare/baseline_remeshers.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <cstdint>

namespace gpr::bench {

/// CGAL's Polygon_mesh_processing::isotropic_remeshing (after Botsch and Kobbelt 2004) to about
/// faceNum faces. CGAL takes an edge length, not a count: up to eight runs from the input, each
/// with a length corrected by the count of the run before, until the count is within 1 %. Returns
/// the nearest result, with the seconds of its run alone. Five iterations per run; edges of 60
/// degrees and more are kept as lines. Fails with a sentence if the mesh is not manifold, or the
/// program was built without CGAL. One thread.
app::BaselineResult remeshByCgal(const app::InputMesh& mesh, std::int64_t faceNum);

} // namespace gpr::bench

#endif
