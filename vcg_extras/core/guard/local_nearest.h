// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_LOCAL_NEAREST_H
#define VCG_EXTRAS_CORE_GUARD_LOCAL_NEAREST_H

#include <vcg_extras/core/surface/surface_point.h>

namespace gpr {

/// The point of a mesh that is nearest to p among those that lie downhill from vertex `from`:
/// from face to face, always nearer to p. So another sheet that is nearer is never taken. `from`
/// must be in a face. facing: only faces that look to the same side as this vector count; 0: all.
/// The face is -1 where none does. Cost: the faces round the vertices on the way.
SurfacePoint nearestByDescent(const HalfEdgeMesh& mesh, int from, const Vec3f& p,
							  const Vec3f& facing = Vec3f());

} // namespace gpr

#endif
