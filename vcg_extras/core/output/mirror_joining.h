// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_MIRROR_JOINING_H
#define VCG_EXTRAS_CORE_OUTPUT_MIRROR_JOINING_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/input/mirror_half.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/results.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// Half a mesh and its mirror image, joined at the vertices of the plane.
struct JoinedHalves {
	/// The half's vertices and faces first, in their order.
	ResultMesh         result;
	std::vector<Vec3d> positions; ///< in the caller's frame; result.mesh rounds them

	/// Vertices of the plane.
	std::int64_t onPlaneNum = 0;
};

/// Joins a mesh in the plane's coordinates to its image. Where two regions of `region`, a label for
/// each face of the half, or none, meet, and along the plane, edges are marked as lines. Throws
/// Failure where an edge would have more than two faces. Cost: O(F log F), serial.
JoinedHalves joinHalves(const Surface& surface, const MirrorPlane& plane, const TriangleMesh& half,
						const std::vector<std::int32_t>& region);

/// Gives the vertices of a joined result their places on the surface: those of the half that was
/// made, and below the image the nearest points, so that each side has the caller's values there.
/// Cost: a search for each vertex, parallel.
void placeOnSurface(const Surface& surface, const MirrorHalf& half, const MirrorPlane& plane,
					const RemeshResult& made, Workers& workers, JoinedHalves& joined);

} // namespace gpr

#endif
