// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_SAMPLED_DISTANCE_H
#define VCG_EXTRAS_CORE_SURFACE_SAMPLED_DISTANCE_H

#include "certified_distance.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Distances of two meshes from each other, in their own unit.
struct SampledDistance {
	MutualDistance mutual;
	double         vertexDistance = 0; ///< largest of a vertex of the result from the input
};

/// A mesh without dead faces, and its triangles, ready for the search of nearest points.
struct MeasuredMesh {
	const HalfEdgeMesh&     mesh;
	const CertifiedSurface& surface;
};

/// Root mean square and p99.9 are over points that are spread evenly: ten for each face of the
/// result, but at least 20000 and at most 200000. So the p99.9 is known to some percent. The
/// largest distance is that over these points and over the vertices that are in a face: a lower
/// bound; certifiedDistance proves a better one. All figures are 0 where either mesh has no face.
/// Double precision, so that CAD's needles do not make it wrong. Cost: so many searches, and one
/// for each vertex, parallel.
SampledDistance sampledDistance(const MeasuredMesh& input, const MeasuredMesh& result,
								Workers& workers);

} // namespace gpr

#endif
