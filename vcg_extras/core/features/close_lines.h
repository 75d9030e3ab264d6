// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CLOSE_LINES_H
#define VCG_EXTRAS_CORE_FEATURES_CLOSE_LINES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <vector>

namespace gpr {

/// Finds edges of feature lines (surface.mesh.crease) that run too close to a border or to a
/// stronger feature line. Too close is nearer over the surface than `gap` (working units, times the
/// local size), as triangles of this size would have to fill the strip between the lines. Returns
/// the smaller half-edge of each edge, ascending.
///
/// Distances are measured straight across the surface, square to the lines. A border always stays.
/// Of two chains, a chain that continues a kept chain stays, else the stronger chain, by the sum of
/// edge length times dihedral angle. Beside a border twice the gap is too close. Both outlines of a
/// thin sheet stay: only the two lines hold its sides apart. Lines that meet at more than a small
/// angle are not close at their meeting point. A stretch that is too close goes on until the
/// distance is 1.6 gaps. Needs: connected. Cost: the faces crossed, a few for each edge of a line.
std::vector<int> findCloseLines(const Surface& surface, float gap, Workers& workers);

} // namespace gpr

#endif
