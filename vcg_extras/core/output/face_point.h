// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_FACE_POINT_H
#define VCG_EXTRAS_CORE_OUTPUT_FACE_POINT_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>
#include <vcg_extras/core/surface/surface_point.h>

namespace gpr {

/// The point of the surface below the middle of face f of the result: the best end of the straight
/// walks from the corners' surface points. A walk never changes to another sheet, as a search
/// might. Cost: the faces crossed.
SurfacePoint pointOfFace(const Surface& surface, const ResultMesh& result, int f);

/// Whether face f of the result is inverted, as seen from all three corners. The normal seen from a
/// corner is the sum of the surface normals at four places: below the middle of the face and below
/// three points round the middle, found by walks as above. So the far wall of a thin sheet does not
/// count, and a corner on a rim or fold alone does not make the face inverted. Cost: twelve walks.
bool isInverted(const Surface& surface, const ResultMesh& result, int f);

} // namespace gpr

#endif
