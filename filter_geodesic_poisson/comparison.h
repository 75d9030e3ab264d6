// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_COMPARISON_H
#define FILTER_GEODESIC_POISSON_COMPARISON_H

// The whole remeshing and MeshLab's Quadric Edge Collapse on the same mesh; independent of
// MeshLab's document.

#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/surface/surface_distance.h>

#include <string>
#include <vector>

namespace gpr_filter {

/// The figures of a mesh of any maker.
struct MeasuredMesh {
	gpr::MeshFigures    figures;
	gpr::QualityFigures quality;
};

/// One of the two results.
struct ComparedResult {
	gpr::TriangleMesh    mesh;
	double               seconds = 0; ///< from mesh in memory to mesh in memory
	MeasuredMesh         measured;
	gpr::SurfaceDistance toInput;   ///< of the points of the result from the input
	gpr::SurfaceDistance fromInput; ///< of the points of the input from the result
	gpr::DistanceBounds  proven;    ///< of the largest distance, of both ways
	std::vector<float>   shape;     ///< of each face: 2·inradius/circumradius
	std::vector<float>   deviation; ///< of each face: root mean square distance from the input
};

struct Comparison {
	MeasuredMesh             input;
	ComparedResult           remeshed;
	ComparedResult           collapsed;
	gpr::RemeshReport        report; ///< of the remeshing
	std::vector<std::string> notes;  ///< of the remeshing
};

/// Remeshes the mesh, has Quadric Edge Collapse make as many faces, and measures both results. The
/// time limit of the options is for the whole. Throws Refusal: if remeshing fails, if Quadric Edge
/// Collapse cannot reach the number of faces, out of time, cancelled. Cost: both runs, and some
/// seconds a million faces.
Comparison compareWithQuadricCollapse(const gpr::MeshView& input, const gpr::RemeshOptions& options,
									  const gpr::ProgressCallback& progress);

} // namespace gpr_filter

#endif
