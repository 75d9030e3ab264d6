// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_BASELINE_MESHOPTIMIZER_H
#define VCG_EXTRAS_BENCH_BASELINE_MESHOPTIMIZER_H

#include <vcg_extras/apps/gpremesh/compare/baseline_remeshers.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <cstdint>

namespace gpr::bench {

/// meshopt_simplify (Arseny Kapoulkine's meshoptimizer) down to faceNum faces, for any error: from
/// indices and positions in memory to indices in memory; seconds leave out the copy of the
/// remaining vertices. meshopt_simplify keeps its own idea of the topology and may stop before
/// faceNum. One thread. Fails with a sentence if the program was built without meshoptimizer.
app::BaselineResult simplifyByMeshoptimizer(const app::InputMesh& mesh, std::int64_t faceNum);

} // namespace gpr::bench

#endif
