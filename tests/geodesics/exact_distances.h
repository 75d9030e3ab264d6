// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_GEODESICS_EXACT_DISTANCES_H
#define GPR_TESTS_GEODESICS_EXACT_DISTANCES_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>
#include <vcg_extras/core/surface/walk.h>

#include <map>

namespace gpr::test {

/// Exact geodesic distances on the polyhedron from a point, by CGAL's Surface_mesh_shortest_path
/// (Xin and Wang 2009). Only faces within the distance `within` are used: on a larger piece the
/// exact algorithm would take hours. Cost: about a second for 3000 faces.
class ExactDistances {
public:
	ExactDistances(const HalfEdgeMesh& mesh, const SurfacePoint& source, double within);

	/// The distances of at most `within`, by vertex.
	const std::map<int, double>& all() const { return distance_; }

private:
	std::map<int, double> distance_;
};

} // namespace gpr::test

#endif
