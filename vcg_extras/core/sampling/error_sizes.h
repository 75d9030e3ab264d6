// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_ERROR_SIZES_H
#define VCG_EXTRAS_CORE_SAMPLING_ERROR_SIZES_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cstdint>

namespace gpr {

/// The range of sizes by the error.
struct ErrorSizeRange {
	float largest; ///< edge on flat ground over the edge of even triangles; above 1
	float slope;   ///< largest growth of sizes over the distance
};
/// The range for a given error bound, and the range for a given count.
constexpr ErrorSizeRange rangeWithinError = {2, 0.2f}, rangeOfCount = {1.3f, 0.15f};

/// Edges of triangles as large as the error allows.
struct ErrorSizes {
	Buffer<float> edge; ///< per vertex, working units
	float epsilon = 0;  ///< flatness of each triangle's disk, working units; forecasts the error
};

/// Computes sizes by the error at the scale of the triangles. The edge at a vertex is the largest h
/// for which the disk of radius h/2 round the vertex is flat to within ε. The flatness of a disk is
/// half of its extent along its mean normal. So rims, tips, thin sheets and limbs get small
/// triangles, whatever their curvature, and the rest gets the largest edge; no edge is below a
/// quarter of `even`. ε makes the number of triangles the same as with the edge `even` everywhere:
/// the area mean of (even / h)² is 1. On a noisy surface ε is not below the noise, and there are
/// fewer triangles.
///
/// Beside a feature line a disk sees only its own side. Lines are marks per half-edge, on both
/// halves of an edge, or empty.
///
/// Needs a connected surface in spatial order; edges may have any length. Fills the rings of the
/// surface if empty, and cuts the surface along the lines meanwhile. The same bits for any number
/// of threads. Cost: linear; about five disks for each square of an even edge, fewer on
/// nearly flat ground, and a closer look at disks that bend.
ErrorSizes sizesByError(Surface& surface, const Buffer<char>& lines, float even,
						const ErrorSizeRange& range, Workers& workers);

/// The count at which nearly all triangles are as flat as the error bound demands. range: of the
/// sizes of the triangles. lines: as in sizesByError. area: of the surface, working units squared.
/// first: a guess. error: the error bound, mesh units. most: the largest count to return. Cost:
/// three times the cost of sizesByError.
std::int64_t countForFlatness(Surface& surface, const Buffer<char>& lines,
							  const ErrorSizeRange& range, double area, std::int64_t first,
							  double error, std::int64_t most, Workers& workers);

} // namespace gpr

#endif
