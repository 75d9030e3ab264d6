// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CLOSE_LINES_H
#define VCG_EXTRAS_CORE_FEATURES_CLOSE_LINES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <vector>

namespace gpr {

/// Edges of feature lines (surface.mesh.crease) that run beside a border or a stronger feature
/// line, nearer to it over the surface than `gap` (working units, times the size there): triangles
/// as long as that would have to fill the strip between the two. Named by their smaller half-edges,
/// ascending.
///
/// Straight ways across the surface, square to the lines, tell how near they are. Borders stay; of
/// two chains the stronger one does, by length times the angle of the faces, or the one that goes
/// on from a chain that stays. Beside a border twice the gap is too near. Both
/// outlines of a thin sheet stay, which only they hold apart. Lines that meet at more
/// than a small angle are not near each other where they meet. A stretch that is too near reaches
/// on as long as the other line does not leave. Needs: connected. Cost: the faces crossed, some for
/// each edge of a line.
std::vector<int> findCloseLines(const Surface& surface, float gap, Workers& workers);

} // namespace gpr

#endif
