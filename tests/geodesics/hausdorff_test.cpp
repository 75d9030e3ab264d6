// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The bounds of the Hausdorff distance against CGAL's, which come from another branch and bound
// (Tang, Lee, Kim 2009) with other bounds of the pieces.

#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <gtest/gtest.h>
#include <string>

// The kernel comes first: the header of the distances does not include all its needs.
// clang-format off
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
// clang-format on

namespace gpr::test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;

struct Pair {
	std::string  name;
	TriangleMesh a, b;
};

Mesh meshOf(const TriangleMesh& mesh)
{
	Mesh to;
	for (const Vec3d& p : mesh.positions)
		to.add_vertex({p.x, p.y, p.z});
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const auto* t = &mesh.triangles[3 * f];
		to.add_face(Mesh::Vertex_index(std::uint32_t(t[0])),
					Mesh::Vertex_index(std::uint32_t(t[1])),
					Mesh::Vertex_index(std::uint32_t(t[2])));
	}
	return to;
}

/// CGAL's answer is at most so far from the distance.
double cgalDistance(const TriangleMesh& a, const TriangleMesh& b, double error)
{
	return CGAL::Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<
		CGAL::Sequential_tag>(meshOf(a), meshOf(b), error);
}

TriangleMesh remeshed(const TriangleMesh& mesh, std::int64_t vertexNum)
{
	RemeshOptions options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = vertexNum;
	options.threads         = 2;
	return remesh(mesh.view(), options).mesh;
}

std::vector<Pair> pairs()
{
	Random            random(11);
	std::vector<Pair> list = {
		{"sphere and icosahedron", icosphere(4), icosphere(0)},
		{"parallel planes", grid(9, 9), shifted(grid(5, 7), {0, 0, 0.2})},
		{"planes beside each other", grid(9, 9), shifted(grid(5, 7), {0.3, 0.1, 0.1})},
		{"offset tori", torus(40, 20, 1, 0.4), torus(31, 23, 1, 0.43)}};
	for (int i = 0; i < 6; ++i) {
		const TriangleMesh mesh = noisySphere(3, random.between(0.02, 0.2), random);
		list.push_back({"remeshed sphere " + std::to_string(i), mesh, remeshed(mesh, 150)});
		const TriangleMesh rough = jitteredGrid(20, 0.3, random);
		list.push_back({"turned sheets " + std::to_string(i), rough,
						rotated(rough, {0.3, 1, 0.2}, random.between(0.01, 0.5))});
	}
	list.push_back({"remeshed cube", cube(10), remeshed(cube(10), 200)});
	return list;
}

} // namespace

TEST(CertifiedDistance, AgreesWithCgal)
{
	Workers workers(2, nullptr);
	for (const Pair& p : pairs()) {
		SCOPED_TRACE(p.name);
		ASSERT_GT(p.b.faceNum(), 0u);
		const double          diagonal = measureMesh(p.a.view()).diagonal;
		const double          error    = 1e-4 * diagonal;
		const MeasuredSurface ofA(p.a.view(), workers), ofB(p.b.view(), ofA, workers);
		const DistanceBounds  bounds =
			certifiedDistances(ofA, ofB, usualCertificate(diagonal), workers).hausdorff();
		const double other = cgalDistance(p.a, p.b, error);
		EXPECT_FALSE(bounds.isBudgetSpent);
		EXPECT_LE(bounds.upper, 1.01 * bounds.lower + 1e-5 * diagonal);
		EXPECT_LE(bounds.lower, other + error);
		EXPECT_GE(bounds.upper, other - error);
	}
}

} // namespace gpr::test
