// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_SECTORS_H
#define VCG_EXTRAS_CORE_MESH_SECTORS_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>

namespace gpr {

// Feature lines cut the star of a vertex into sectors. Like the star of a border vertex, each
// sector is flat or not, and its angle decides the wanted number of faces.

/// Cosine of the largest angle (about 37°) of faces that count as flat with their mean normal.
constexpr float flatCosine = 0.8f;

/// Whether the faces of each sector of v lie within about 37° of their mean normal.
bool isFlat(const HalfEdgeMesh& mesh, int v);

/// Marks flat vertices. Moving other vertices would round off sharp features.
Buffer<char> findFlatVertices(const HalfEdgeMesh& mesh, Workers& workers);

/// Number of faces at a vertex, corrected so that 6 is ideal everywhere: the ideal of a sector, or
/// of the star of a border vertex, is the number of 60° angles in its angle, and at least 1. 6 for
/// dead vertices.
int correctedValence(const HalfEdgeMesh& mesh, int v);

/// The corrected valences of all vertices.
Buffer<int> correctedValences(const HalfEdgeMesh& mesh, Workers& workers);

// The energy Σ(valence - 6)² measures the distance of a mesh from a lattice of equilateral
// triangles.

/// The energy of a vertex.
inline int squaredDefect(int valence)
{
	return (valence - 6) * (valence - 6);
}

/// The change of the energy by flipping the inner edge h.
int flipEnergy(const HalfEdgeMesh& mesh, const Buffer<int>& valence, int h);

} // namespace gpr

#endif
