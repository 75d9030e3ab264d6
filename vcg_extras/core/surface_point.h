// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_POINT_H
#define VCG_EXTRAS_CORE_SURFACE_POINT_H

#include "connect.h"
#include "mesh_view.h"
#include "walk.h"

namespace gpr {

/// Where a point of the engine's surface lies on the caller's mesh: the caller's face and the
/// weights of its corners.
SurfacePoint surfacePoint(const MeshView& input, const Surface& surface, const Anchor& anchor);

/// Vertex v of the engine's surface, as a point of it; v must be in a face.
inline Anchor anchorOfVertex(const Surface& surface, int v)
{
	return {surface.mesh.position[v], surface.mesh.outgoing[v] / 3};
}

} // namespace gpr

#endif
