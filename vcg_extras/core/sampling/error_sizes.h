// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_ERROR_SIZES_H
#define VCG_EXTRAS_CORE_SAMPLING_ERROR_SIZES_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <cstdint>

namespace gpr {

/// What sizes by the error are made for; all lengths in working units.
struct ErrorSizeRequest {
	float even;    ///< the edge of the triangles if all had one size
	float largest; ///< the edge where the surface is flat; above `even`
	float slope;   ///< by how much sizes may grow over the distance
};

/// The edges of triangles that are as large as the error allows.
struct ErrorSizes {
	Buffer<float> edge; ///< per vertex, working units
	float epsilon = 0;  ///< how flat each triangle's disk is, working units; forecasts the error
};

/// Sizes by the error at the scale of the triangles: the edge at a vertex is the largest h at which
/// the disk of radius h/2 round it is flat to within ε. Flatness is half of the disk's extent along
/// its mean normal. So rims, tips, thin sheets and limbs ask for small triangles, whatever their
/// curvature, and all else has the edge `largest`; none is below a quarter of `even`. ε is such
/// that the number of triangles is that of the edge `even` everywhere: the area mean of (even / h)²
/// is 1. It is not below the noise of the surface: there are fewer triangles then.
///
/// On either side of a feature line a disk sees that side alone; lines are per half-edge, at both
/// halves of an edge, or empty.
///
/// Needs a connected surface in spatial order; edges may be of any length. The same bits for any
/// number of threads. Cost: linear. Five disks for each square of an even edge, but where the
/// surface hardly turns, and a closer look where they are not flat.
ErrorSizes sizesByError(const HalfEdgeMesh& mesh, const Buffer<char>& lines,
						const ErrorSizeRequest& request, Workers& workers);

/// How far sizes by the error may differ.
struct ErrorSizeRange {
	float largest; ///< the edge where the surface is flat, over that of even triangles
	float slope;   ///< see ErrorSizeRequest
};
/// Where a largest error is asked for, and where all sizes of a given count follow the error.
constexpr ErrorSizeRange rangeWithinError = {2, 0.2f}, rangeOfCount = {1.3f, 0.15f};

/// The count with which triangles would be as flat as a largest error asks for, but for few of
/// them. range: of the sizes that triangles will have; lines: as above. area: of the surface,
/// working units squared; first: a guess; error: mesh units; most: no larger count is returned.
/// Cost: three times that of sizesByError.
std::int64_t countForFlatness(const Surface& surface, const Buffer<char>& lines,
							  const ErrorSizeRange& range, double area, std::int64_t first,
							  double error, std::int64_t most, Workers& workers);

} // namespace gpr

#endif
