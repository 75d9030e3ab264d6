// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_DISTANCE_GUARD_H
#define VCG_EXTRAS_CORE_GUARD_DISTANCE_GUARD_H

#include "guarded_decimation.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/face_contact.h>

#include <vector>

namespace gpr {

/// Predicts whether a change of a mesh would move it away from the points assigned to its vertices.
/// Quadrics do not show this: quadrics are weighted by area, and the rim of a thin sheet has next
/// to no area. Each point belongs to the nearest face of the mesh, found from the point's vertex.
/// 24 B per face and 16 B per point.
class DistanceGuard {
public:
	/// enough: distance up to which points may get farther off. Checks only points of vertices that
	/// may move or have a neighbour that may move; at a vertex with many points an even selection.
	/// The mesh must stay in memory.
	DistanceGuard(const GuardedMesh& guarded, double enough, Workers& workers);

	/// Whether the triangles `made` may replace the faces `gone`: no point of `gone` gets farther
	/// off than `enough`, or than the farthest point of `gone` is now. Cost: some 20 ns per pair of
	/// a point and a triangle.
	bool allows(const std::vector<NamedTriangle>& made, const std::vector<int>& gone) const;

	/// Updates the points after a change. changed: the faces that moved.
	void follow(const std::vector<int>& changed);

private:
	/// A point of the surface.
	struct Point {
		Vec3f at;
		float squared; ///< distance from its face
	};

	const HalfEdgeMesh&             m_;
	float                           squaredEnough_;
	std::vector<std::vector<Point>> pointsOf_; ///< per face
};

} // namespace gpr

#endif
