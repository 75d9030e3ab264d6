// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_RELAXATION_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_RELAXATION_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Per vertex: whether all faces of its ring, or of each of its sectors (sectors.h), lie within
/// about 37° of their mean normal. Moving others would round off what is sharp there.
Buffer<char> findFlatVertices(const ResultMesh& result, Workers& workers);

/// From v to the barycentre of its ring, weighted by area, and by the density at the vertices if
/// there is one.
Vec3f wayToBarycentre(const HalfEdgeMesh& mesh, int v, const Buffer<float>& density = {});

/// Stage 10: one relaxation step on the surface: every flat free vertex walks to the area-weighted
/// barycentre of its ring, all at once (Jacobi). Moves that would fold a face, or make a poor one
/// poorer, are taken back. Vertices never leave the input's surface. Cost: linear, parallel.
void relaxOnce(const Surface& surface, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
