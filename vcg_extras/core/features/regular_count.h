// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_REGULAR_COUNT_H
#define VCG_EXTRAS_CORE_FEATURES_REGULAR_COUNT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

namespace gpr {

/// Forecasts the edge length at which about 95 % of the triangles have no angle below 30°.
/// Triangles much wider than the strip between two crease edges cannot be regular. Such a strip
/// holds one triangle for each edge length along each of its two sides. So the share of these
/// triangles at the edge length h is h √3 / 4 times the length of the sides with a strip narrower
/// than about h / 2, over the area. Returns the largest such h up to `edge`. angle: of the normals
/// at a crease edge, radians; borders count as crease edges. Lengths in working units. Cost: the
/// faces crossed within half an `edge` of the crease edges, parallel.
float edgeForRegularity(const HalfEdgeMesh& mesh, double area, float edge, float angle,
						Workers& workers);

} // namespace gpr

#endif
