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

/// A connected part of the surface whose faces have one label.
struct RegionPiece {
	std::int32_t label = 0;
	double       area  = 0; ///< of the caller's mesh, its units squared
};

/// The regions that the faces of a result belong to.
struct RegionLabels {
	std::vector<SurfacePoint> middle; ///< per face: a point of its region, below its middle
	std::vector<RegionPiece>  lost;   ///< without a face in the result, the largest first
};

/// Tells to which region of the caller's (MeshView::region, which must be there) each face of the
/// result belongs. The faces between lines of the result belong together: they get the region that
/// most of their middles lie in. Where a line has gaps, so that more than one region lies there,
/// each face gets its own, evened out by its neighbours. Cost: linear but for a walk for each face,
/// which is parallel.
RegionLabels labelFaces(const MeshView& input, const Surface& surface, const ResultMesh& result,
						Workers& workers);

} // namespace gpr

#endif
