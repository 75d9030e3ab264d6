// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_FACE_POINT_H
#define VCG_EXTRAS_CORE_OUTPUT_FACE_POINT_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>
#include <vcg_extras/core/surface/surface_point.h>

namespace gpr {

/// Where on the surface the middle of face f of the result lies: the end of the straight way from a
/// corner's surface point that comes nearest to it. Walked, not searched for, so that it is never
/// on another sheet. Cost: the faces crossed.
SurfacePoint pointOfFace(const Surface& surface, const ResultMesh& result, int f);

/// Whether the normal of face f of the result points against the normal of what the face stands
/// for: from each of its corners, the sum of the surface's normals under the middle of the face and
/// under three points round it, found by walks as above. A wall behind a thin sheet is never asked.
/// Nor is the face counted for a rim or fold that some of its corners lie on, where another corner
/// sees what it stands for. Cost: twelve walks.
bool isInverted(const Surface& surface, const ResultMesh& result, int f);

} // namespace gpr

#endif
