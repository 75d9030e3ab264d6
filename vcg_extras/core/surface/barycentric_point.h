// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_BARYCENTRIC_POINT_H
#define VCG_EXTRAS_CORE_SURFACE_BARYCENTRIC_POINT_H

#include "surface_point.h"

#include <vcg_extras/core/mesh_view.h>

namespace gpr {

/// The place of a point of the working surface on the input mesh: a face of the input and the
/// weights of its corners.
BarycentricPoint barycentricPoint(const MeshView& input, const Surface& surface,
								  const SurfacePoint& point);

} // namespace gpr

#endif
