// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_UMBRELLA_SMOOTHING_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_UMBRELLA_SMOOTHING_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Stage 10 as the paper has it (§3, last paragraph): one step of the second-order umbrella
/// operator of Kobbelt, Campagna, Vorsatz and Seidel (1998),
///
///   U(p) = mean of the neighbours - p,  U²(p) = mean of the neighbours' U - U(p),
///   p <- p - U²(p) / ν,                 ν = 1 + (mean of 1 over the neighbours' valences),
///
/// for all vertices at once.
///
/// Differs from the paper: only the tangential part of a step is taken, by walking on the surface,
/// so that nothing leaves it; steps that fold a face or make a poor one poorer are taken back (see
/// MoveGuard). Vertices of curves, tips and vertices on creases stay; at a border U is that of the
/// border polygon, so that the border does not draw the inside towards it.
/// Needs vertices that lie on the surface. Cost: linear, in parallel.
void smoothByUmbrella2(const Surface& surface, ResultMesh& result, Workers& workers);

/// U² / ν at every vertex, before anything is made tangential.
Buffer<Vec3f> secondOrderUmbrella(const HalfEdgeMesh& mesh, Workers& workers);

} // namespace gpr

#endif
