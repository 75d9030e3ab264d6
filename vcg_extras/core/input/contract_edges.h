// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_CONTRACT_EDGES_H
#define VCG_EXTRAS_CORE_INPUT_CONTRACT_EDGES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Contracts edges without length: vertices at the very same place, joined by edges, become a
/// single vertex; the faces between are dropped. CAD programs write such faces as strips without
/// width: each side of a strip would get samples of its own, and the triangles between would be
/// degenerate. A cluster of such vertices stays if contracting would change the topology, or make
/// an edge or a vertex that is not manifold. The exception: holes of three edges, with an edge
/// without length, have no area and are closed. Vertices and faces keep their order. Cost: a
/// parallel pass over the faces; for contractions O(n log n) in the n faces concerned.
void contractEdgesWithoutLength(IndexedMesh& mesh, Workers& workers, CleanCounts& counts);

} // namespace gpr

#endif
