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
/// smaller than a neighbour. Those that are lowered are appended to it, so that it has each vertex
/// once, in an order that does not depend on the threads. Cost: that of the vertices that are
/// lowered, and a mark for each of the others.
void gradeSizes(const HalfEdgeMesh& mesh, float slope, Workers& workers, std::vector<int>& small,
				Buffer<float>& size);

} // namespace gpr

#endif
