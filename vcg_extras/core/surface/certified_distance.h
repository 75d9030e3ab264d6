// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_CERTIFIED_DISTANCE_H
#define VCG_EXTRAS_CORE_SURFACE_CERTIFIED_DISTANCE_H

#include "surface_distance.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/report.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// The wanted tightness of the bounds, and the largest cost.
struct CertificateSettings {
	double relative = 0.01; ///< upper is at most (1 + relative) lower + absolute
	double absolute = 0;    ///< mesh units, at least some millionths of the extent
	/// A bound to prove, mesh units; 0: none. If the distance is at most this bound, so is upper,
	/// even if the distance is only a little smaller.
	double wanted = 0;
	/// Largest error of the coordinates, mesh units; the bounds hold in spite of such errors.
	double coordinateError = 0;
	/// Pieces of triangles to look at for each direction, beside the triangles, at most.
	std::int64_t budget = 4000000;
};

/// Settings for the distances of reports: 1 % of the distance and 1e-5 of the diagonal.
CertificateSettings usualCertificate(double diagonal);

/// Bounds of the one-sided Hausdorff distance: the largest distance of a point of surface `from`
/// from surface `to`. All 0 if either has no face. Both surfaces need the same origin.
///
/// The lower bound is the largest distance measured at a point. The upper bound comes by branch and
/// bound (Guthe, Borodin, Klein 2005: Fast and accurate Hausdorff distance calculation between
/// meshes; the bounds differ from theirs): triangles of `from` are cut until a bound of each piece
/// is below the goal. The least of three bounds counts:
/// - The distance from a single triangle of `to` is a convex function, so a corner of the piece has
///   the largest value.
/// - coverBound.
/// - The largest distance of a corner, plus the longest way to the nearest corner.
/// A cut goes through a point with equal distances from two triangles of `to`, else through the
/// middle of the longest edge.
///
/// Both bounds have a slack of 2e-7 of the extent of the two surfaces, plus coordinateError: far
/// more than rounding can do. If the budget is spent, the bounds hold but are wider, and
/// isBudgetSpent is set. The same bits for any number of threads. Cost: a search for each triangle
/// that may be near the largest distance and for some more triangles, parallel.
DistanceBounds certifiedDistance(const MeasuredSurface& from, const MeasuredSurface& to,
								 const CertificateSettings& settings, Workers& workers);

/// A triangle with a point that is farther from another surface than a limit.
struct FarPlace {
	Vec3d  position;     ///< of the farthest measured point, in the frame of the mesh
	double distance = 0; ///< of this point
	double area     = 0; ///< of the triangle
};

/// The triangles of `from` with points farther than the limit from `to`, as found by seven points
/// of each triangle or by cuts. All other triangles are proven to be near, except a few close to
/// the limit. regions: if any are given, in the frame of the mesh, only triangles in or near a
/// region count: all whose boxes meet a region, and some within a 64th of the extent. The same for
/// any number of threads. Cost: as the first step of certifiedDistance.
std::vector<FarPlace> placesBeyond(const MeasuredSurface& from, const MeasuredSurface& to,
								   double limit, Workers& workers,
								   const std::vector<Box<double>>& regions = {});

/// certifiedDistance in both directions between an input and a result.
MutualBounds certifiedDistances(const MeasuredSurface& input, const MeasuredSurface& result,
								const CertificateSettings& settings, Workers& workers);

/// Distances of an input and a result from each other.
struct ComparedDistance {
	DistanceFigures toInput;   ///< of the points of the result from the input
	DistanceFigures fromInput; ///< of the points of the input from the result
	MutualBounds    proven;    ///< of the largest distances
};

/// Measures the distances in both directions with distanceSampleNum points, and proves bounds of
/// the largest distances with usualCertificate. A larger distance found by the proof counts as
/// measured. Cost: measuring and proving, some seconds per million faces.
ComparedDistance compareSurfaces(const MeshView& input, const MeasuredSurface& inputSurface,
								 const MeshView& result, double diagonal, Workers& workers);

} // namespace gpr

#endif
