// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_BORDER_SPIKES_H
#define VCG_EXTRAS_CORE_INPUT_BORDER_SPIKES_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// The faces, ascending, of spikes of the border that are narrower than `width`: parts that a disk
/// of this diameter, rolled over the surface inside the border, does not come to (a morphological
/// opening by distances along the surface). What sticks out of the rest by less than a third of the
/// width stays. A spike is a disk that hangs on the rest by one line. All other narrow parts stay:
/// bridges, rims round a hole, components that are narrow everywhere. So the surface without these
/// faces has the components, holes and handles that it had, and is manifold. The mesh must be
/// manifold. Cost: serial; O(n log n) for n vertices nearer to the border than half the width.
std::vector<int> findBorderSpikes(const HalfEdgeMesh& mesh, float width);

} // namespace gpr

#endif
