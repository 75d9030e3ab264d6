// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_SIZING_H
#define VCG_EXTRAS_CORE_SAMPLING_SIZING_H

#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// The local sizes: for every vertex of the surface its disk radius over the largest disk radius,
/// in (0, 1].
struct Sizing {
	Buffer<float> size;                 ///< empty: the same everywhere
	double        radiusFactor = 1;     ///< largest disk radius over the radius of eq. (1)
	bool          areByError   = false; ///< and by nothing else
	/// With TargetMode::Sizes: half the number of faces for the sizes, and the number of border
	/// edges.
	double       vertexNum = 0, borderEdgeNum = 0;
	std::int64_t clampedNum = 0; ///< equations as printed: vertices with 1 + λH below 0.1
};

/// The inputs of the sizing of a run.
struct SizingRequest {
	const RemeshOptions&    options;
	float                   radius;          ///< from eq. (1), working units
	float                   evenEdge;        ///< edge of equal triangles, working units
	const Buffer<char>&     lines;           ///< feature lines, per half-edge; empty: none
	const Buffer<char>&     isFeatureVertex; ///< per vertex of the surface; empty: none
	const std::vector<int>& kept;            ///< input vertices to keep, ascending
	/// Wanted edges at the vertices of the surface, from the user, working units; empty: none.
	const Buffer<float>& wantedEdge;
};

/// Stage::Sizing: computes the density of the samples (paper §3.1.2) and the smaller disks of a
/// feature region (§3.1.1).
///
/// Calibrated: distances are stretched, eq. (4), by s = min(1 + λ·|H|·r, largestStretch), without
/// unit. H is averaged over a disk of radius r. Sizes 1/s may grow by at most gradingSlope of the
/// distance, so that angles stay good. The number of samples goes with the area mean of s², so the
/// radius is multiplied by the root of this mean.
///
/// As printed: s = max(1 + λ·H, 0.1) with the signed H of each vertex in 1/mesh unit. H is averaged
/// over a disk here too: the paper does not define it, and noise would drown a local value. The
/// radius is multiplied by the vertex mean of 1 + λ·H, eq. (5), which overshoots the count if the
/// curvature varies.
///
/// With BoundaryMode::Keep sizes at the border follow the spacing of the border vertices.
///
/// `adapt` (calibrated only) multiplies sizes by the sizes of sizesByError. Their largest size is 1
/// + 0.3·adapt times the size of even triangles; with TargetMode::MaxError rangeWithinError holds.
/// Each side of a feature line has its own size.
///
/// Wanted edges of the user (calibrated only) multiply all this, and the product is kept between
/// minEdge and maxEdge. With TargetMode::Sizes wanted edges are lengths, and the count follows;
/// with any other target they are scaled to the count.
///
/// Cost: linear; for λ a pass over the mesh for every edge along r, squared.
Sizing makeSizing(const SizingRequest& request, Surface& surface, Workers& workers);

/// Mean curvature H at every vertex in 1/working unit, positive where the surface bulges along its
/// normals. The divergence of the vertex normals over each face (half of it is H) is summed and
/// divided by the area over the ring, then averaged `ringPasses` times over rings. Nothing is
/// divided by the area of a single face, so needles do no harm.
Buffer<float> meanCurvature(const Surface& surface, int ringPasses, Workers& workers);

} // namespace gpr

#endif
