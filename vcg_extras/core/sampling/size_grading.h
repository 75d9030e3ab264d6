// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_SIZE_GRADING_H
#define VCG_EXTRAS_CORE_SAMPLING_SIZE_GRADING_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// Lowers sizes at the vertices until no size grows along an edge by more than `slope` times the
/// length of the edge. `small`: the vertices whose neighbours may be too large, at least all
/// vertices smaller than a neighbour by more than that. On return `small` holds these vertices and
/// all lowered vertices, each once, in an order independent of the threads. Cost: O(log n) for each
/// of n lowered vertices, and a mark for each other vertex; parallel.
void gradeSizes(const HalfEdgeMesh& mesh, float slope, Workers& workers, std::vector<int>& small,
				Buffer<float>& size);

} // namespace gpr

#endif
