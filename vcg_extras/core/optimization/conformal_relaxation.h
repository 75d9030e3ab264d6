// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_CONFORMAL_RELAXATION_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_CONFORMAL_RELAXATION_H

#include "delaunay_flips.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Steps of the descent and their weights.
struct ConformalSteps {
	int   stepNum    = 10;
	float momentum   = 0.8f;          ///< share of the last move that is made again, in [0, 1)
	float rate       = 0.7f;          ///< of a Newton step with the Hessian's diagonal, in (0, 1]
	int   flipPasses = untilDelaunay; ///< at most, each time that edges are flipped
};

/// Weights that suit a number of steps: the longer the way, the more momentum.
ConformalSteps conformalSteps(int stepNum);

/// Moves vertices on the surface so that the triangles become equilateral: descent with momentum
/// (heavy ball, Polyak 1964) on the sum over the faces of the conformal energy of Hormann and
/// Greiner, MIPS (2000), E = (|a|² + |b|² + |c|²) / (4√3·area), 1 for an equilateral triangle. It
/// knows no size, so a graded mesh stays graded. All vertices of flat ground move at once (Jacobi);
/// vertices of curves slide along them, corners and tips stay. Where a ring has a poor
/// triangle, only moves that do not lower its worst angle are made, and no move folds a face (see
/// MoveGuard). Every third step, and at the end, edges are flipped to Delaunay.
/// Cost: linear, parallel; a step costs what a plain relaxation step does.
void relaxConformally(const Surface& surface, const BoundaryCurves& curves,
					  const ConformalSteps& steps, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
