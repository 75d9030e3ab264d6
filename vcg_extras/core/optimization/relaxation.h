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

/// Number of relaxation steps for regular triangles; more steps change little.
constexpr int relaxationSteps = 3;

/// Stage::Relaxation: vertices move on the surface by the terms of terms.h, and never leave the
/// surface. Only flat vertices walk (findFlatVertices). No move folds a face or makes a poor face
/// poorer (see MoveGuard). Needs vertices on the surface. Cost of a step: linear, parallel.

/// Relaxation step: every vertex walks to the area-weighted barycentre of its ring, all at once
/// (Jacobi). Vertices of curves stay.
void relaxOnce(const Surface& surface, ResultMesh& result, Workers& workers);

/// Relaxation step for the vertices of feature lines: each vertex slides along its line towards the
/// barycentre of its ring, in sequence, unless the chords would be too far from the line. Cost: the
/// rings of these vertices; serial.
void slideAlongCreases(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result);

/// Step of the second-order umbrella of the paper (§3, last paragraph), for all vertices at once.
/// Differs from the paper: only the tangential part of a step is taken, by walking on the surface.
/// Vertices of curves, cone apexes and vertices on creases stay.
void smoothByUmbrella2(const Surface& surface, ResultMesh& result, Workers& workers);

/// Makes triangles equilateral: descent with momentum on the sum of the conformal energy over the
/// faces. The energy does not depend on sizes, so a graded mesh stays graded. All vertices move at
/// once (Jacobi); corners and cone apexes stay. In a ring with a poor triangle, a move must not
/// lower the worst angle. Three steps go through space; then the vertices walk to the new places,
/// vertices of curves slide along their curves, and edges are flipped to Delaunay.
void relaxConformally(const Surface& surface, const BoundaryCurves& curves, int stepNum,
					  ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
