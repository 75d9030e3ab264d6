// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_FACE_TREE_H
#define VCG_EXTRAS_CORE_SURFACE_FACE_TREE_H

#include "surface_point.h"
#include "walk.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// Bounding-box tree over the faces of a mesh, for nearest points. Only samples that the engine did
/// not place itself need it: everything else is found by walking.
class FaceTree {
public:
	/// workers: null, or asked now and then whether to go on. Cost: O(F log F), serial.
	explicit FaceTree(const HalfEdgeMesh& mesh, Workers* workers = nullptr);

	/// The point of the mesh nearest to p. Cost: O(log F) on well-behaved meshes.
	SurfacePoint nearest(const Vec3f& p) const;

private:
	struct Node {
		Vec3f low, high;
		int   begin, end; ///< faces of a leaf
		int   left = -1, right = -1;
	};

	const HalfEdgeMesh& m_;
	Workers*            workers_;
	std::vector<int>    face_;
	std::vector<Node>   node_;

	int   build(int begin, int end);
	float squaredDistance(const Node& n, const Vec3f& p) const;
};

} // namespace gpr

#endif
