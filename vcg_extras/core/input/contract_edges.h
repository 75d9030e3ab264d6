// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_CONTRACT_EDGES_H
#define VCG_EXTRAS_CORE_INPUT_CONTRACT_EDGES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Contracts edges without length: vertices at the very same place that edges join become one, and
/// the faces between them are dropped. CAD programs write such faces, as strips without width: each
/// side of a strip would get samples of its own, and the triangles between them no area. What is
/// contracted must not change the topology, nor make an edge or a vertex that is not manifold; else
/// it stays. Holes of three edges, one of them without length, are the exception: they have no area
/// and are closed. Vertices and faces keep their order. Cost: a parallel pass over the faces; for
/// what has to be contracted, O(n log n) in the faces there.
void contractEdgesWithoutLength(IndexedMesh& mesh, Workers& workers, CleanCounts& counts);

} // namespace gpr

#endif
