// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_NEAREST_ON_MESH_H
#define VCG_EXTRAS_CORE_SURFACE_NEAREST_ON_MESH_H

#include "surface_point.h"
#include "triangle_tree.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

namespace gpr {

/// Nearest points of a mesh without dead faces, as points of its faces.
class NearestOnMesh {
public:
	/// The mesh must stay unchanged. Throws as Workers do. Cost: see TriangleTree.
	NearestOnMesh(const HalfEdgeMesh& mesh, Workers& workers) :
			m_(mesh), tree_(viewOf(mesh), {}, workers)
	{
	}

	/// Nearest point. Of equally near faces the face of lowest index counts. Face -1 if the mesh
	/// has no face or p is not finite. Cost: O(log F) on well-behaved meshes.
	SurfacePoint nearest(const Vec3f& p) const
	{
		const int f = tree_.nearestFace(Vec3d(p));
		if (f < 0) return {};
		const auto [a, b, c] = m_.corners(f);
		return {nearestOnTriangle(p, a, b, c), f};
	}

private:
	const HalfEdgeMesh& m_;
	TriangleTree        tree_;
};

} // namespace gpr

#endif
