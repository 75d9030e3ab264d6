// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_BASELINE_CGAL_H
#define VCG_EXTRAS_BENCH_BASELINE_CGAL_H

#include <vcg_extras/apps/gpremesh/compare/baseline_remeshers.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <cstdint>

namespace gpr::bench {

/// CGAL's Polygon_mesh_processing::isotropic_remeshing (after Botsch and Kobbelt 2004) to about
/// faceNum faces. It takes an edge length, not a count. So it is run up to eight times from the
/// input, each time with a length that is corrected by the faces that came out, until the count is
/// within 1 %; the nearest result is returned, with the seconds of its run alone. Five iterations a
/// run; edges of 60 degrees and more are kept as lines. Needs a manifold mesh; fails with a
/// sentence where it is none, or where the program was built without CGAL. One thread.
app::BaselineResult remeshByCgal(const app::InputMesh& mesh, std::int64_t faceNum);

} // namespace gpr::bench

#endif
