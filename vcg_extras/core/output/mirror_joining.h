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

/// Half of a mesh and its mirror image, joined at the vertices on the mirror plane.
struct JoinedHalves {
	/// Vertices and faces of the half come first, in their order.
	ResultMesh         result;
	std::vector<Vec3d> positions; ///< in the frame of the input; result.mesh rounds the positions

	/// The number of vertices on the plane.
	std::int64_t onPlaneNum = 0;
};

/// Joins a mesh in the coordinates of the plane to its mirror image. Edges on the plane, and edges
/// between two labels of `region` (per face of the half, or empty), become feature lines. Throws
/// Failure if an edge would have more than two faces. Cost: O(F log F), serial.
JoinedHalves joinHalves(const Surface& surface, const MirrorPlane& plane, const TriangleMesh& half,
						const std::vector<std::int32_t>& region, Workers& workers);

/// Sets the surface points of a joined result. Vertices of the half get the points of `made`.
/// Vertices of the image get the nearest points of the surface, so that both sides carry over
/// values of their own side. Cost: a search per image vertex, parallel.
void placeOnSurface(const Surface& surface, const MirrorHalf& half, const MirrorPlane& plane,
					const RemeshResult& made, Workers& workers, JoinedHalves& joined);

} // namespace gpr

#endif
