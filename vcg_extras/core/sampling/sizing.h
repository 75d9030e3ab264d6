// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_SIZING_H
#define VCG_EXTRAS_CORE_SAMPLING_SIZING_H

#include "fine_spots.h"

#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/surface/result_mesh.h>
#include <vcg_extras/core/surface/surface_point.h>
#include <vcg_extras/core/surface/walk.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// How large the triangles are to be where: for every vertex of the surface the disk radius there
/// over the largest one, in (0, 1].
struct Sizing {
	Buffer<float> size;                              ///< empty: the same everywhere
	double        radiusFactor = 1;                  ///< largest disk radius over that of eq. (1)
	float         longestEdge  = longestEdgeInRadii; ///< of the surface, in local disk radii
	double        vertexNum    = 0; ///< with TargetMode::Sizes: that the sizes take
	std::int64_t  clampedNum   = 0; ///< equations as printed: vertices where 1 + λH fell below 0.1
};

/// What the sizing of a run is made from.
struct SizingRequest {
	const RemeshOptions&    options;
	float                   radius;          ///< of eq. (1), working units
	float                   evenEdge;        ///< of triangles that all have one size, working units
	const Buffer<char>&     lines;           ///< feature lines, per half-edge; empty: none
	const Buffer<char>&     isFeatureVertex; ///< per vertex of the surface; empty: none
	const std::vector<int>& kept;            ///< the caller's vertices that stay, ascending
	const FineSpots*        fineSpots = nullptr; ///< where triangles are to be smaller; or null
	/// Edges that the caller wants at the vertices of the surface, working units; empty: none.
	const Buffer<float>* wantedEdge = nullptr;
};

/// Stage::Sizing: the density of the samples (paper §3.1.2), and the smaller disks of a feature
/// region (§3.1.1).
///
/// Calibrated: the stretch of distances, eq. (4), is s = min(1 + λ·|H|·r, largestStretch), without
/// unit, H averaged over a disk of radius r; sizes 1/s may grow by gradingSlope of the distance
/// only, so that angles stay good; since the number of samples goes with the area mean of s², the
/// radius is multiplied by the root of it.
/// As printed: s = max(1 + λ·H, 0.1) with the signed H of each vertex in 1/mesh unit, averaged over
/// a disk too (the paper does not say how it is found, and noise would drown it), and the radius
/// times the vertex mean of 1 + λ·H, eq. (5), which overshoots the count wherever the curvature
/// varies. With BoundaryMode::Keep sizes at the border go with the spacing of its own vertices.
///
/// With `adapt` (calibrated only) sizes are multiplied by those of sizesByError, whose largest one
/// is 1 + 0.3·adapt times that of even triangles, and with TargetMode::MaxError those of
/// rangeWithinError. On either side of a feature line they are those of that side.
///
/// Edges that the caller wants are multiplied with all this (calibrated only), and what comes out
/// is kept between minEdge and maxEdge. With TargetMode::Sizes they are lengths, and the count
/// follows; with any other target they are scaled to it.
///
/// Where fine spots are given sizes are multiplied with their factors (calibrated only).
///
/// Cost: linear; for λ a pass over the mesh for every edge that r spans, squared.
Sizing makeSizing(const SizingRequest& request, const Surface& surface, Workers& workers);

/// Area mean of 1/size², for sizes at the vertices; 1 where there is no area. The number of
/// triangles goes with it.
double meanSquaredStretch(const HalfEdgeMesh& mesh, const Buffer<float>& size, Workers& workers);

/// Mean curvature H at every vertex in 1/working unit, positive where the surface bulges along its
/// normals: the divergence of the vertex normals over each face (half of it is H), summed and
/// divided by the area over the ring, then averaged over so many further rings. Needs no division
/// by the area of a single face, so slivers do no harm.
Buffer<float> meanCurvature(const Surface& surface, int ringPasses, Workers& workers);

} // namespace gpr

#endif
