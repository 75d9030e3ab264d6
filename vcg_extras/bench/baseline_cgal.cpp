// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "baseline_cgal.h"

#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/base/stopwatch.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace gpr::bench {

namespace {

namespace cgal = CGAL::Polygon_mesh_processing;
using Point    = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh     = CGAL::Surface_mesh<Point>;

constexpr int    mostRuns       = 8;
constexpr double nearEnough     = 0.01; // share of the count
constexpr int    iterationNum   = 5;
constexpr double sharpAngleDeg  = 60;                 // as in CGAL's own examples
constexpr double areaOfUnitFace = 0.4330127018922193; // equilateral, edges of length 1

bool meshOf(const MeshView& view, Mesh& mesh)
{
	std::vector<Point> points;
	for (std::size_t v = 0; v < view.vertexNum; ++v) {
		const Vec3d p = view.position(v);
		points.emplace_back(p.x, p.y, p.z);
	}
	std::vector<std::array<std::int32_t, 3>> faces;
	for (std::size_t f = 0; f < view.faceNum; ++f)
		faces.push_back(view.triangle(f));
	if (!cgal::is_polygon_soup_a_polygon_mesh(faces)) return false;
	cgal::polygon_soup_to_polygon_mesh(points, faces, mesh);
	return true;
}

TriangleMesh arraysOf(const Mesh& mesh)
{
	TriangleMesh              arrays;
	std::vector<std::int32_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
	for (const auto v : mesh.vertices()) {
		number[v.idx()] = std::int32_t(arrays.positions.size());
		arrays.positions.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
	}
	for (const auto f : mesh.faces())
		for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
			arrays.triangles.push_back(number[v.idx()]);
	return arrays;
}

Mesh remeshed(Mesh mesh, double edgeLength)
{
	auto isSharp = get(CGAL::edge_is_feature, mesh);
	cgal::detect_sharp_edges(mesh, sharpAngleDeg, isSharp);
	const auto options = CGAL::parameters::number_of_iterations(iterationNum);
	cgal::isotropic_remeshing(mesh.faces(), edgeLength, mesh,
							  options.edge_is_constrained_map(isSharp));
	return mesh;
}

/// The result of the run with the nearest count.
app::BaselineResult nearestResult(const Mesh& input, double area, std::int64_t faceNum)
{
	app::BaselineResult best;
	std::int64_t        bestOff    = -1;
	double              edgeLength = std::sqrt(area / (areaOfUnitFace * double(faceNum)));
	for (int run = 0; run < mostRuns; ++run) {
		const double         processorBefore = app::processorSeconds();
		const app::Stopwatch clock;
		const Mesh           mesh  = remeshed(input, edgeLength);
		const std::int64_t   found = std::int64_t(mesh.number_of_faces());
		const std::int64_t   off   = std::abs(found - faceNum);
		if (bestOff < 0 || off < bestOff) {
			best.seconds          = clock.seconds();
			best.processorSeconds = app::processorSeconds() - processorBefore;
			best.mesh             = arraysOf(mesh);
			bestOff               = off;
		}
		if (double(off) <= nearEnough * double(faceNum)) break;
		edgeLength *= std::sqrt(double(found) / double(faceNum));
	}
	return best;
}

} // namespace

app::BaselineResult remeshByCgal(const app::InputMesh& mesh, std::int64_t faceNum)
{
	app::BaselineResult result;
	Mesh                input;
	if (!meshOf(mesh.view(), input)) {
		result.failure = "CGAL wants a manifold mesh.";
		return result;
	}
	result = nearestResult(input, cgal::area(input), faceNum);
	if (result.mesh.triangles.empty()) result.failure = "CGAL left no face.";
	return result;
}

} // namespace gpr::bench
