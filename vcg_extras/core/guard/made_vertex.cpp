// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_vertex.h"

#include <vcg_extras/core/surface/local_nearest.h>

namespace gpr {

ResultVertex madeVertex(const Surface& surface, int surfaceVertex, const GuardedMesh& made, int v)
{
	ResultVertex vertex;
	vertex.point    = nearestByDescent(surface.mesh, surfaceVertex, made.mesh.position[v]);
	vertex.normal   = surface.mesh.faceNormal(vertex.point.face);
	vertex.isPinned = made.isFixed(v);
	vertex.isMade   = true;
	return vertex;
}

} // namespace gpr
