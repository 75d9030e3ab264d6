// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_SURFACE_POINT_H
#define VCG_EXTRAS_CORE_SURFACE_SURFACE_POINT_H

#include <vcg_extras/core/mesh/connect.h>

namespace gpr {

/// A point of the working surface.
struct SurfacePoint {
	Vec3f position;
	int   face = -1;
};

/// Vertex v of the working surface as a point; v must be in a face.
inline SurfacePoint pointOfVertex(const Surface& surface, int v)
{
	return {surface.mesh.position[v], surface.mesh.outgoing[v] / 3};
}

} // namespace gpr

#endif
