// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_REGION_LABELS_H
#define VCG_EXTRAS_CORE_OUTPUT_REGION_LABELS_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// A largest set of linked faces of the surface with the same label.
struct RegionPiece {
	std::int32_t label = 0;
	double       area  = 0; ///< area on the input, mesh units squared
};

/// The regions of a result's faces.
struct RegionLabels {
	std::vector<SurfacePoint> middle; ///< per face: a point of its region, below its middle
	std::vector<RegionPiece>  lost;   ///< pieces without a face in the result, the largest first
};

/// Assigns each face of the result to a region of the input (needs MeshView::region). All faces
/// between feature lines of the result get the region of most of their middles. If several regions
/// lie between the lines, because a line has gaps, each face gets the region of its own middle,
/// smoothed by its neighbours. Cost: linear, and a walk per face, which is parallel.
RegionLabels labelFaces(const MeshView& input, const Surface& surface, const ResultMesh& result,
						Workers& workers);

} // namespace gpr

#endif
