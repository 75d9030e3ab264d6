// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_CROSSING_MENDING_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_CROSSING_MENDING_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/cells.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// After stage 12: faces that cross each other though they did so before the fit, which takes only
/// its own moves back: at spikes, folds and sheets thinner than the triangles are long. Vertices of
/// these faces move over the surface, up and down, those of curves along these, and edges are
/// flipped, wherever fewer pairs of faces cross then. Refused is what makes the worst angle there
/// worse and less than angleDeg, takes the vertices of the input that belong there further away
/// than a tenth of an edge and than before, or makes a face agree less with the surface's
/// normals.
///
/// `suspects`: all faces that may cross others are among them, ascending. Needs a mesh without
/// dead faces; `cells` are those of its faces. Returns the faces that still cross others. Cost:
/// nothing where there are no suspects; else a search among them and milliseconds for each that
/// crosses, 200 at most.
std::vector<int> mendCrossings(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
							   const std::vector<int>& suspects, const Cells& cells,
							   ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
