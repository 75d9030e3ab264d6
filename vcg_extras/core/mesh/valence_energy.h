// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_VALENCE_ENERGY_H
#define VCG_EXTRAS_CORE_MESH_VALENCE_ENERGY_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>

namespace gpr {

// The energy Σ(valence - 6)² measures the distance of a mesh from a lattice of equilateral
// triangles.

/// Number of faces at every vertex, corrected at curves so that 6 is ideal everywhere (sectors.h);
/// 6 for dead vertices.
Buffer<int> correctedValences(const HalfEdgeMesh& mesh, Workers& workers);

/// The energy of a vertex.
inline int squaredDefect(int valence)
{
	return (valence - 6) * (valence - 6);
}

/// The change of the energy by flipping the inner edge h.
int flipEnergy(const HalfEdgeMesh& mesh, const Buffer<int>& valence, int h);

} // namespace gpr

#endif
