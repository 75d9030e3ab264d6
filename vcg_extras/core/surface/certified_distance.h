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

/// How near to each other the bounds shall come, and what that may cost.
struct CertificateSettings {
	double relative = 0.01; ///< upper is at most (1 + relative) lower + absolute
	double absolute = 0;    ///< mesh units, at least some millionths of the extent
	/// Coordinates may be wrong by so much, mesh units; the bounds hold all the same.
	double coordinateError = 0;
	/// Pieces of triangles that may be looked at for each direction, beside the triangles.
	std::int64_t budget = 4000000;
};

/// Goal of the distance that reports tell: 1 % of it and 1e-5 of the diagonal.
CertificateSettings usualCertificate(double diagonal);

/// Bounds of the largest distance of a point of one surface from another: the one-sided Hausdorff
/// distance. All 0 where either has no face. Both need the same origin.
///
/// Lower: the largest distance of a point that was looked at. Upper, by branch and bound (Guthe,
/// Borodin, Klein 2005: Fast and accurate Hausdorff distance calculation between meshes; the bounds
/// are others): triangles of the first surface are cut until a bound of each piece is below the
/// goal. A piece has three bounds, of which the least counts. The distance from a single triangle
/// of the other surface is a convex function, so it is largest at a corner of the piece. The second
/// is coverBound. The third is what corners have, and the way to them. Pieces are cut where two
/// triangles of the other surface are equally near, else in the middle of the longest edge.
///
/// Both bounds have a slack of 2e-7 of the extent of the two surfaces, and coordinateError, which
/// is far more than rounding can do. Where the budget is spent, the bounds are as good as they are
/// then, and say so. The same bits for any number of threads. Cost: a search for each triangle that
/// may be near the largest distance and for some of the others, parallel.
DistanceBounds certifiedDistance(const MeasuredSurface& from, const MeasuredSurface& to,
								 const CertificateSettings& settings, Workers& workers);

/// A triangle with a point that is farther from another surface than a limit.
struct FarPlace {
	Vec3d  position;     ///< of the farthest point that was looked at, in the frame of the mesh
	double distance = 0; ///< its
	double area     = 0; ///< of the triangle
};

/// The triangles of a surface with points farther than the limit from another one, as far as seven
/// points of each, or cutting it, show it. Of the others a bound is proven, but for a few that are
/// near the limit. Only triangles whose boxes meet one of the regions are looked at, if there are
/// any; these are few, and in the frame of the mesh. The same for any number of threads. Cost: as
/// the first step of certifiedDistance.
std::vector<FarPlace> placesBeyond(const MeasuredSurface& from, const MeasuredSurface& to,
								   double limit, Workers& workers,
								   const std::vector<Box<double>>& regions = {});

/// Both ways between an input and a result.
MutualBounds certifiedDistances(const MeshView& input, const MeshView& result,
								const CertificateSettings& settings, Workers& workers);

/// Distances of an input and a result from each other.
struct ComparedDistance {
	DistanceFigures toInput;   ///< of the points of the result from the input
	DistanceFigures fromInput; ///< of the points of the input from the result
	MutualBounds    proven;    ///< of the largest distances
};

/// Measures both ways, as many points as a comparison takes (distanceSampleNum), and proves the
/// largest distances as reports tell them. What the proof finds farther off counts as measured.
/// Cost: that of both, some seconds a million faces.
ComparedDistance compareSurfaces(const MeshView& input, const MeasuredSurface& inputSurface,
								 const MeshView& result, double diagonal, Workers& workers);

} // namespace gpr

#endif
