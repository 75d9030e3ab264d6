// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_LOCAL_NEAREST_H
#define VCG_EXTRAS_CORE_SURFACE_LOCAL_NEAREST_H

#include "surface_point.h"

namespace gpr {

// The nearest point on the same sheet: from face to face over the vertices that they share, always
// nearer to p, so that another sheet that is nearer is never taken. Cost: the faces on the way.

/// From `face`, which is then the one that the point lies in. Ends at a point within the root of
/// `enough`, and after 64 faces.
Vec3f nearestOnTheWay(const HalfEdgeMesh& mesh, const Vec3f& p, float enough, int& face);

/// From vertex `from`, which must be in a face. facing: only faces that look to the same side as
/// this vector count; 0: all. The face is -1 where none does.
SurfacePoint nearestByDescent(const HalfEdgeMesh& mesh, int from, const Vec3f& p,
							  const Vec3f& facing = Vec3f());

} // namespace gpr

#endif
