// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_DISTANCE_GUARD_H
#define VCG_EXTRAS_CORE_GUARD_DISTANCE_GUARD_H

#include "guarded_decimation.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/face_contact.h>

#include <vector>

namespace gpr {

/// Says before a mesh is changed whether it would leave points of the surface that it stands for
/// farther off. Quadrics do not tell that: they are weighted by area, and the rim of a thin sheet
/// has next to none. Each point belongs to the face that is nearest to it on the mesh itself, from
/// the vertex on that stands for it. 8 B a face and 24 B a point.
class DistanceGuard {
public:
	/// Up to `enough` points may get farther off. Only those of vertices that may move, or have a
	/// neighbour that may, are looked at; of many at a vertex, some evenly taken. The mesh must
	/// stay where it is.
	DistanceGuard(const GuardedMesh& guarded, double enough, Workers& workers);

	/// Whether the triangles `made` may take the places of the faces `gone`: no point of these
	/// comes to lie farther off than is enough, or than the farthest of them does now. Cost: some
	/// 20 ns for each pair of a point and a triangle.
	bool allows(const std::vector<NamedTriangle>& made, const std::vector<int>& gone) const;

	/// To be called after each change with the faces that lie elsewhere now.
	void follow(const std::vector<int>& changed);

private:
	/// A point of the surface, and the face that it belongs to.
	struct Point {
		Vec3f at;
		int   face;
		float squared; ///< distance from that
		int   next;    ///< of the same face, or -1
	};

	const HalfEdgeMesh& m_;
	float               squaredEnough_;
	std::vector<Point>  point_;
	std::vector<int>    first_; ///< per face

	void putInList(int point);

	template <class Visit>
	void forEachPointOf(const std::vector<int>& faces, const Visit& visit) const
	{
		for (int f : faces) {
			for (int i = first_[std::size_t(f)]; i >= 0; i = point_[std::size_t(i)].next)
				visit(point_[std::size_t(i)]);
		}
	}
};

} // namespace gpr

#endif
