// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_SIZE_GRADING_H
#define VCG_EXTRAS_CORE_SAMPLING_SIZE_GRADING_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// Lowers sizes at the vertices until none grows along an edge by more than `slope` times the
/// edge's length. `small` are the vertices whose neighbours may have to be lowered: all that are
/// smaller than a neighbour. It then has these and all that were lowered, each once, in an order
/// that does not depend on the threads. Cost: O(log n) for each of n vertices that are lowered, and
/// a mark for each of the others; parallel.
void gradeSizes(const HalfEdgeMesh& mesh, float slope, Workers& workers, std::vector<int>& small,
				Buffer<float>& size);

} // namespace gpr

#endif
