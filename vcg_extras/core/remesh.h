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

/// Remeshes a surface with about equilateral triangles of equal size: all steps of "Fast Edge-based
/// geodesic Poisson Disk Remeshing", with the placement by disk intersection. Accepts any triangle
/// mesh: non-manifold parts are repaired or cut and counted in report.cleaned. The input is never
/// modified.
///
/// With selectedOnly the result has the unselected faces in their order, then the new faces; both
/// share the vertices of the seam between them. Counts, figures and checks are then of the selected
/// part. Refused if an edge of the seam has more than two faces.
///
/// The result depends on input, options and seed, not on the number of threads. Cost: linear in the
/// input; docs/measurements.md has seconds. Throws on programming errors only.
RemeshResult remesh(const MeshView& input, const RemeshOptions& options,
					const ProgressCallback& progress = nullptr);

/// Samples a surface (paper §3, steps 1–8): points at least (1-ε) r apart, with a point within r of
/// every vertex of the input. The count is within about a tenth of the target, without correction.
SamplingResult samplePoissonDisks(const MeshView& input, const RemeshOptions& options,
								  const ProgressCallback& progress = nullptr);

/// Makes a mesh with the topology of the input from given samples (paper §3, last paragraph). The
/// vertices are the samples, at their given places; a sample off the surface moves to the nearest
/// point first (report.samplesMoved, report.largestSampleMove). If the topology needs more vertices
/// than samples, vertices of the input stay: report.leftoverVertexNum. Target, exact count,
/// smoothing and fit of the options have no effect.
RemeshResult retriangulate(const MeshView& input, const std::vector<Vec3d>& samples,
						   const RemeshOptions&    options,
						   const ProgressCallback& progress = nullptr);

/// Finds creases and cone apexes by a uniformly supported second-order difference (paper §3.1; see
/// feature_detection.h and docs/features.md). Reads featureThresholds and threads of the options.
/// Works on a copy in which non-manifold parts are repaired or cut; a cut edge is no feature.
/// Cost: linear; about 2 s per million faces and core.
FeatureResult detectFeatures(const MeshView& input, const RemeshOptions& options,
							 const ProgressCallback& progress = nullptr);

} // namespace gpr

#endif
