// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_GUARDED_RELAXATION_H
#define VCG_EXTRAS_CORE_GUARD_GUARDED_RELAXATION_H

#include "guarded_decimation.h"

namespace gpr {

/// Makes the triangles of a decimated mesh more regular: edges are flipped where the worse of two
/// faces gets a better shape, vertices are drawn to the barycentre of their faces while their
/// quadrics hold them on the surface. No change turns a face, or turns one against the normals of
/// what it stands for, or makes faces touch that did not (ContactGuard). Edges between faces that
/// meet at more than 40° are sharp and are flipped only where they become less so. Neither takes
/// the triangles farther from the surface than 10 % of the ideal edge (working units), or than they
/// were: by the quadrics, and by the points that the vertices stand for (DistanceGuard). Vertices
/// of borders and fixed ones stay, faces between fixed ones too. Without mayMove edges are flipped
/// only. Needs a mesh without dead faces. Serial but for the trees. Cost: about 200 µs a vertex.
void relaxGuarded(double idealEdge, bool mayMove, GuardedMesh& guarded, Workers& workers);

} // namespace gpr

#endif
