// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_LABELS_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_LABELS_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// Position of a vertex of the result relative to the patches: far away, near, with marked and
/// other faces, or with marked faces only.
enum class PatchRole : char { Far, Near, Border, Inside };

/// Prepares the cells at the border of a patch for merging each cell into a vertex. A piece apart
/// from the largest piece of its cell goes to a neighbour. Inner vertices that meet a cell twice,
/// and inner pieces enclosed by one or two cells, go to such a cell. Vertices beyond the border
/// that meet inner vertices go to a cell beside. label: per vertex of the mesh; role: per label.
/// Cost: some passes over the mesh, serial.
void cleanLabels(const HalfEdgeMesh& mesh, const std::vector<PatchRole>& role,
				 std::vector<int>& label, Workers& workers);

} // namespace gpr

#endif
