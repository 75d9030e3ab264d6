// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_on_mesh.h"

#include <vcg_extras/core/base/triangle.h>

namespace gpr {

NearestOnMesh::NearestOnMesh(const HalfEdgeMesh& mesh, Workers& workers) :
		m_(mesh), tree_(viewOf(mesh), {}, workers)
{
}

SurfacePoint NearestOnMesh::nearest(const Vec3f& p) const
{
	const int f = tree_.nearestFace(Vec3d(p));
	if (f < 0) return {};
	const auto corner = [&](int k) { return m_.position[m_.origin[3 * f + k]]; };
	return {nearestOnTriangle(p, corner(0), corner(1), corner(2)), f};
}

} // namespace gpr
