// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_VALENCE_GLIDE_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_VALENCE_GLIDE_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// How far ahead glideDislocations looks, in flips.
constexpr int usualGlideDepth = 6;

/// Pairs of a 5- and a 7-valent vertex are dislocations of the lattice. A flip moves one along its
/// glide line at no change of Σ(valence - 6)²; where it meets another the energy falls. From every
/// vertex of seven or more faces, chains of up to `depth` flips are searched, depth first and
/// shortest first, whose energy never rises above the start; the first chain that ends below it is
/// kept, all others are undone. No flip makes a face turn over, an angle below 17° or a dihedral
/// beyond 37°, and all happen on flat ground. Vertices do not move: relaxation follows. Returns the
/// number of chains kept. Cost: some hundred trial flips for each vertex of seven faces; parallel
/// by cells of space (see ColouredGrid), whose borders chains do not cross far.
std::int64_t glideDislocations(ResultMesh& result, Workers& workers, int depth = usualGlideDepth);

} // namespace gpr

#endif
