// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_GUARDED_RELAXATION_H
#define VCG_EXTRAS_CORE_GUARD_GUARDED_RELAXATION_H

#include "guarded_decimation.h"

namespace gpr {

/// Makes the triangles of a decimated mesh more regular. Flips an edge if the worse of both faces
/// gets a better shape; moves vertices towards the barycentre of their faces, held to the surface
/// by their quadrics. No change turns a face too far, by itself or against the assigned normals, or
/// makes new contacts (ContactGuard). Edges between faces at more than 40° are creases, flipped
/// only if they become less sharp. No change moves triangles farther from the surface than 10 % of
/// idealEdge (working units), or than before: by the quadrics, and by the assigned points
/// (DistanceGuard). Border vertices, fixed vertices and faces between fixed vertices stay. Without
/// mayMove only edges are flipped. Needs a mesh without dead faces. Serial but for the trees. Cost:
/// about 200 µs per vertex.
void relaxGuarded(double idealEdge, bool mayMove, GuardedMesh& guarded, Workers& workers);

} // namespace gpr

#endif
