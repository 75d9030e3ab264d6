// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_RELAXATION_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_RELAXATION_H

#include "delaunay_flips.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Relaxation steps that make triangles regular; more change little.
constexpr int relaxationSteps = 3;

/// Stage::Relaxation: vertices move on the surface, which they never leave, by the terms of
/// terms.h. Only flat vertices walk (findFlatVertices). No move folds a face or makes a poor one
/// poorer (see MoveGuard). Needs vertices that lie on the surface. Cost of a step: linear,
/// parallel.

/// One relaxation step: every vertex walks to the area-weighted barycentre of its ring, all at once
/// (Jacobi). Vertices of curves stay.
void relaxOnce(const Surface& surface, ResultMesh& result, Workers& workers);

/// One relaxation step for the vertices of feature lines: each slides along its line towards the
/// barycentre of its ring, one after the other, unless the line would leave its chords further than
/// it may. Cost: the rings of these vertices; serial.
void slideAlongCreases(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result);

/// One step of the second-order umbrella, as the paper has it (§3, last paragraph), for all
/// vertices at once. Differs from the paper: only the tangential part of a step is taken, by
/// walking on the surface. Vertices of curves, cone apexes and vertices on creases stay.
void smoothByUmbrella2(const Surface& surface, ResultMesh& result, Workers& workers);

/// Steps of relaxConformally and their weights.
struct ConformalSteps {
	int   stepNum  = 10;
	float momentum = 0.8f; ///< share of the last move that is made again, in [0, 1)
	float rate     = 0.7f; ///< of a Newton step with the Hessian's diagonal, in (0, 1]
};

/// Weights that suit a number of steps: the longer the way, the more momentum.
ConformalSteps conformalSteps(int stepNum);

/// Moves vertices so that the triangles become equilateral: descent with momentum on the sum over
/// the faces of the conformal energy. It knows no size, so a graded mesh stays graded. All vertices
/// move at once (Jacobi); corners and cone apexes stay. Where a ring has a poor triangle, only
/// moves that do not lower its worst angle are made. Three steps go through space; then the
/// vertices walk to these places, those of curves slide along them, and edges are flipped to
/// Delaunay.
void relaxConformally(const Surface& surface, const BoundaryCurves& curves,
					  const ConformalSteps& steps, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
