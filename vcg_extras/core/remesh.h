// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_REMESH_H
#define VCG_EXTRAS_CORE_REMESH_H

#include "mesh_view.h"
#include "options.h"
#include "progress.h"
#include "results.h"

#include <vector>

namespace gpr {

/// Remeshes a surface with about-equilateral triangles of equal size: the whole way of
/// "Fast Edge-based geodesic Poisson Disk Remeshing" with the placement by disk intersection.
/// Needs any triangle mesh; what is not 2-manifold is repaired or cut, counted in report.cleaned.
/// With selectedOnly the result is the faces that are not selected, in their order, then the new
/// ones; both share the vertices of the seam between them. Counts, figures and checks are of the
/// selected part. Refused where the seam has an edge of more than two faces.
/// The input is never modified. The result depends on input, options and seed only, not on threads.
/// Cost: linear in the input; docs/measurements.md has seconds.
/// Never throws but for programming errors.
RemeshResult remesh(const MeshView& input, const RemeshOptions& options,
					const ProgressCallback& progress = nullptr);

/// The sampling stage alone (paper §3, steps 1–8): points at least (1-ε) r apart, every vertex of
/// the input within r of one. The count lands within about a tenth of the target (no correction).
SamplingResult samplePoissonDisks(const MeshView& input, const RemeshOptions& options,
								  const ProgressCallback& progress = nullptr);

/// Retriangulation from given samples (paper §3, last paragraph): a mesh with the input's topology
/// whose vertices are the samples, each exactly where it was given. Samples off the surface are put
/// on it first (nearest point); report.samplesMoved and report.largestSampleMove tell how many and
/// how far. Where the topology needs more vertices than there are samples, vertices of the input
/// stay: report.leftoverVertexNum. Of the options, the target, the exact count, the smoothing and
/// the fit do not count.
RemeshResult retriangulate(const MeshView& input, const std::vector<Vec3d>& samples,
						   const RemeshOptions&    options,
						   const ProgressCallback& progress = nullptr);

/// Finds creases and cone apexes by a uniformly supported second-order difference (paper §3.1; see
/// feature_detection.h and docs/features.md). Of the options, featureThresholds and threads count.
/// A mesh that is not 2-manifold is repaired or cut for this; edges cut are no features.
/// The input is never modified. Cost: linear; about 2 s per million faces and core.
FeatureResult detectFeatures(const MeshView& input, const RemeshOptions& options,
							 const ProgressCallback& progress = nullptr);

} // namespace gpr

#endif
