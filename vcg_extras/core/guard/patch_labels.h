// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_LABELS_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_LABELS_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// Where a vertex of the result lies that is the label of others.
enum class PatchRole : char { Far, Near, Border, Inside };

/// Makes the cells on the border of a patch fit to be drawn together. Pieces of such a cell that
/// are apart from its largest one go to a neighbour, a vertex inside that meets one cell twice goes
/// to that cell, and so does what lies inside but is enclosed by one or two cells.
/// label: per vertex of the mesh; role: per label. Cost: some passes over the mesh, serial.
void cleanLabels(const HalfEdgeMesh& mesh, const std::vector<PatchRole>& role,
				 std::vector<int>& label);

} // namespace gpr

#endif
