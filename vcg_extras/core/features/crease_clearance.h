// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CREASE_CLEARANCE_H
#define VCG_EXTRAS_CORE_FEATURES_CREASE_CLEARANCE_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <vector>

namespace gpr {

/// Angle between the normals of the two faces of h, radians; 0 at a border and beside degenerate
/// faces.
float dihedralAngle(const HalfEdgeMesh& mesh, int h);

/// Whether the normals of the two faces of the inner edge h enclose at least an angle, given by its
/// cosine; false beside degenerate faces.
bool isSharpEdge(const HalfEdgeMesh& mesh, int h, float cosine);

/// Tells real crease edges from noise. A real crease is much sharper than the edges beside it; an
/// edge of noise has neighbours nearly as sharp. Returns for each edge in `edges`, all marked as
/// creases in the mesh, whether it is at least three times as sharp as every edge beside it,
/// creases left out; 0 if all edges beside it are creases, as at the corner of a cube.
///
/// If long edges were split, the edges beside a crease edge are the edges of its two input faces:
/// new edges inside an input face are flat, and any noise would look clear beside flat edges.
/// isSplit: whether faces are parts of input faces. Cost: the edges, and with isSplit a pass over
/// the faces; parallel.
std::vector<char> clearEdges(const Surface& surface, bool isSplit, const std::vector<int>& edges,
							 Workers& workers);

} // namespace gpr

#endif
