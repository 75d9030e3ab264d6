// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_LOCAL_NEAREST_H
#define VCG_EXTRAS_CORE_SURFACE_LOCAL_NEAREST_H

#include "surface_point.h"

namespace gpr {

// Searches for the nearest point of the same sheet. A search goes from face to face over shared
// vertices, always nearer to p, so a nearer point of another sheet is never taken. Cost: the faces
// on the way.

/// Nearest point by a search from `face`; afterwards `face` is the face of the point. Ends at a
/// squared distance of at most `enough`, and after 64 hops from face to face.
Vec3f nearestOnTheWay(const HalfEdgeMesh& mesh, const Vec3f& p, float enough, int& face);

/// Nearest point by a search from vertex `from`, which must be in a face. facing: only faces with
/// normals on the side of this vector count; 0: all. The face is -1 if no face counts.
SurfacePoint nearestByDescent(const HalfEdgeMesh& mesh, int from, const Vec3f& p,
							  const Vec3f& facing = Vec3f());

} // namespace gpr

#endif
