// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_MESH_COPIES_H
#define VCG_EXTRAS_BENCH_MESH_COPIES_H

#include <vcg_extras/core/result_mesh.h>

namespace gpr::bench {

/// The engine's meshes cannot be copied by accident; stages that change one are measured on copies.
HalfEdgeMesh copyOf(const HalfEdgeMesh& mesh);
ResultMesh   copyOf(const ResultMesh& result);

} // namespace gpr::bench

#endif
