// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_distances.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace gpr::test {

namespace {

using Kernel    = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh      = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits    = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Distances = CGAL::Surface_mesh_shortest_path<Traits>;

/// The faces round a point, linked over edges, as far as some part of the face is within a
/// distance.
std::vector<int> facesNear(const HalfEdgeMesh& m, const SurfacePoint& source, double within)
{
	const auto isNear = [&](int f) {
		double longest = 0, nearest = HUGE_VAL;
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			const Vec3d p(m.position[m.origin[h]]);
			nearest = std::min(nearest, length(p - Vec3d(source.position)));
			longest = std::max(longest, length(Vec3d(m.position[m.target(h)]) - p));
		}
		return nearest <= within + longest;
	};
	std::vector<int>        near(1, source.face);
	std::unordered_set<int> seen(near.begin(), near.end());
	for (std::size_t i = 0; i < near.size(); ++i) {
		for (int h = 3 * near[i]; h < 3 * near[i] + 3; ++h) {
			const int beyond = m.opposite[h] < 0 ? -1 : m.opposite[h] / 3;
			if (beyond >= 0 && isNear(beyond) && seen.insert(beyond).second) near.push_back(beyond);
		}
	}
	return near;
}

/// The piece as a mesh of CGAL's.
struct Piece {
	Mesh                                        mesh;
	std::unordered_map<int, Mesh::Vertex_index> vertex; ///< by the whole mesh's
	Mesh::Face_index                            first;

	Piece(const HalfEdgeMesh& m, const std::vector<int>& faces)
	{
		// A face with only a vertex in common so far has to wait for the faces between.
		std::vector<int> left = faces;
		while (!left.empty()) {
			std::vector<int> later;
			for (int f : left) {
				if (!add(m, f, f == faces[0])) later.push_back(f);
			}
			if (later.size() == left.size()) throw std::runtime_error("not a manifold piece");
			left.swap(later);
		}
	}

private:
	bool add(const HalfEdgeMesh& m, int f, bool isFirst)
	{
		Mesh::Vertex_index corner[3];
		for (int k = 0; k < 3; ++k) {
			const int v     = m.origin[3 * f + k];
			auto      found = vertex.find(v);
			if (found == vertex.end()) {
				const Vec3d p(m.position[v]);
				found = vertex.emplace(v, mesh.add_vertex({p.x, p.y, p.z})).first;
			}
			corner[k] = found->second;
		}
		const Mesh::Face_index face = mesh.add_face(corner[0], corner[1], corner[2]);
		if (isFirst) first = face;
		return face != Mesh::null_face();
	}
};

} // namespace

ExactDistances::ExactDistances(const HalfEdgeMesh& m, const SurfacePoint& source, double within)
{
	const Piece                           piece(m, facesNear(m, source, within));
	Distances                             distances(piece.mesh);
	const Traits::Barycentric_coordinates at = [&] {
		double weight[3];
		Vec3d  corner[3];
		for (int k = 0; k < 3; ++k)
			corner[k] = Vec3d(m.position[m.origin[3 * source.face + k]]);
		const Vec3d n = cross(corner[1] - corner[0], corner[2] - corner[0]);
		for (int k = 0; k < 3; ++k) {
			const Vec3d a = corner[(k + 1) % 3], b = corner[(k + 2) % 3];
			weight[k] = dot(cross(b - a, Vec3d(source.position) - a), n) / squaredLength(n);
		}
		// Weights belong to the corners in CGAL's order, which need not begin with ours.
		const auto h     = piece.mesh.halfedge(piece.first);
		const auto first = piece.mesh.source(h);
		int        shift = 0;
		while (piece.vertex.at(m.origin[3 * source.face + shift]) != first)
			++shift;
		return Traits::Barycentric_coordinates{weight[shift], weight[(shift + 1) % 3],
											   weight[(shift + 2) % 3]};
	}();
	distances.add_source_point(piece.first, at);
	for (const auto& [v, vertex] : piece.vertex) {
		const double d = distances.shortest_distance_to_source_points(vertex).first;
		if (d >= 0 && d <= within) distance_[v] = d;
	}
}

} // namespace gpr::test
