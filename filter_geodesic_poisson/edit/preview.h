// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_PREVIEW_H
#define FILTER_GEODESIC_POISSON_PREVIEW_H

// The results of a run of the edit tool for the window; independent of MeshLab.

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/results.h>
#include <vcg_extras/core/surface/surface_distance.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace gpr_filter {

/// A corner of a drawn face; colours are red, green, blue, opaque.
struct DrawnCorner {
	float        position[3];
	float        normal[3];
	std::uint8_t byQuality[4];
	std::uint8_t byDistance[4]; ///< grey until distances were measured
};

/// Faces to be drawn, three corners each, each with a normal of its own.
using DrawnFaces = std::vector<DrawnCorner>;

/// A face to look at, in the layer's own coordinates.
struct Spot {
	bool       isKnown = false;
	gpr::Vec3d middle, normal;
	double     size   = 0; ///< of its longest edge
	double     figure = 0; ///< its quality, or its distance from the input
};

/// A result and its views. Constant once made.
struct Preview {
	std::uint64_t                            request = 0; ///< the number of the answered request
	bool                                     isDraft = false;
	std::shared_ptr<const gpr::RemeshResult> result;
	std::shared_ptr<const DrawnFaces>        faces;
	bool                                     isMeasured = false; ///< distances are known
	gpr::SurfaceDistance                     distance;           ///< the larger of both directions
	double                                   largestDeviation = 0; ///< the red end of the colours
	Spot                                     worstTriangle, farthest;
};

/// The result with its faces, coloured by quality, and the worst face. Cost: linear.
Preview shownResult(std::shared_ptr<const gpr::RemeshResult> result, gpr::Workers& workers);

/// The same with distances from the input, and coloured by distance, too. `target` is the surface
/// of the input. Cost: some seconds a million faces.
Preview measuredResult(const Preview& shown, const gpr::MeshView& input,
					   const gpr::MeasuredSurface& target, gpr::Workers& workers);

/// The faces of any mesh, coloured by quality, and by distance if `target` is not null. `largest`:
/// the distance in red; 0 takes the largest distance of the mesh.
DrawnFaces drawnFaces(const gpr::MeshView& mesh, const gpr::MeasuredSurface* target, double largest,
					  gpr::Workers& workers);

} // namespace gpr_filter

#endif
