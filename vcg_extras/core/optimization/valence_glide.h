// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_VALENCE_GLIDE_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_VALENCE_GLIDE_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Longest chains that glideDislocations searches, in flips.
constexpr int usualGlideDepth = 6;

/// Moves dislocations of the lattice, pairs of a 5- and a 7-valent vertex, together. A flip moves a
/// dislocation along its glide line with no change of Σ(valence - 6)²; if two dislocations meet,
/// the energy falls. From every vertex with seven or more faces, chains of up to `depth` flips are
/// searched, depth first and shortest first, with energies never above the start; the first chain
/// that ends below the start is kept, all other chains are undone. Flips happen on flat ground
/// only, and no flip turns a face over or makes an angle below 17° or a dihedral beyond 37°.
/// Vertices do not move: relaxation follows. Returns the number of kept chains. Cost: some hundred
/// trial flips for each vertex of seven faces; parallel by cells of space (see ColouredGrid);
/// chains reach only a little beyond a cell.
std::int64_t glideDislocations(ResultMesh& result, Workers& workers, int depth = usualGlideDepth);

} // namespace gpr

#endif
