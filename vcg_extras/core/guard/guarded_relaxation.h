// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_GUARDED_RELAXATION_H
#define VCG_EXTRAS_CORE_GUARD_GUARDED_RELAXATION_H

#include "guarded_decimation.h"

namespace gpr {

/// Makes the triangles of a decimated mesh more regular. Flips an edge if the worse of both faces
/// gets a better shape; moves vertices towards the barycentre of their faces, held to the surface
/// by their quadrics. Driver::GuardedRelaxation limits the turn of a face, by itself and against
/// the assigned normals. No change makes new contacts (ContactGuard). No flip makes a sharper
/// crease (above 40°) or leaves one above 45°, except at needles. No change moves triangles
/// farther from the surface than 10 % of idealEdge (working units), or than before, by quadrics and
/// assigned points (DistanceGuard). Border vertices, fixed vertices and faces between fixed
/// vertices stay; without mayMove all vertices. Needs: no dead faces. Serial but for trees of
/// boxes. Cost: about 200 µs per vertex.
void relaxGuarded(double idealEdge, bool mayMove, GuardedMesh& guarded, Workers& workers);

} // namespace gpr

#endif
