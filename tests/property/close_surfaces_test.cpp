// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whole runs where surfaces come close to each other or to a point: no faces intersect, and
// noise makes no lines.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/self_intersections.h>
#include <vcg_extras/core/remesh.h>

#include <functional>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A ridge bent over y under a flat sheet that is nearer than the triangles would rise by the fit.
TriangleMesh ridgeUnderSheet(double gap)
{
	TriangleMesh ridge = grid(100, 100);
	for (Vec3d& p : ridge.positions)
		p.z = -0.75 * (p.x - 0.5) * (p.x - 0.5);
	return joined(ridge, shifted(grid(100, 100), {0.003, 0.004, gap}));
}

TriangleMesh roughSphere()
{
	Random random(7);
	return noisySphere(5, 0.02, random);
}

struct Shape {
	const char*                   name;
	std::function<TriangleMesh()> make;
	int                           vertexNum;
	bool                          hasLines;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

std::size_t crossingNum(const TriangleMesh& mesh)
{
	Workers workers(2, nullptr);
	return findIntersectingFaces(halfEdgesOf(mesh), workers).size();
}

} // namespace

TEST(IntersectingFaces, AreFoundInTheseResultsOnceTheyCross)
{
	EXPECT_EQ(crossingNum(ridgeUnderSheet(0.002)), 0u);
	EXPECT_GT(crossingNum(ridgeUnderSheet(-0.002)), 0u);
}

class CloseSurfaces : public ::testing::TestWithParam<Shape> {};

TEST_P(CloseSurfaces, DoNotCross)
{
	const TriangleMesh mesh = GetParam().make();
	for (const double adapt : {0.0, 1.0}) {
		RemeshOptions options;
		options.targetMode      = TargetMode::VertexNum;
		options.targetVertexNum = GetParam().vertexNum;
		options.adapt           = adapt;
		options.threads         = 2;
		const RemeshResult r    = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(int(r.mesh.vertexNum()), GetParam().vertexNum);
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
		EXPECT_EQ(crossingNum(r.mesh), 0u) << "adapt " << adapt;
		EXPECT_EQ(r.report.featureEdgeNum > 0, GetParam().hasLines);
	}
}

INSTANTIATE_TEST_SUITE_P(
	, CloseSurfaces,
	::testing::Values(Shape{"sheets", [] { return ridgeUnderSheet(0.002); }, 250, false},
					  Shape{"flatSheets", [] { return twoSheets(80, 0.001); }, 400, false},
					  Shape{"cone", [] { return cone(90, 40, 0.5, 2); }, 300, false},
					  Shape{"thinPlate", [] { return thinPlate(60, 0.002); }, 500, true},
					  Shape{"noisySphere", roughSphere, 800, false}),
	[](const auto& shape) { return shape.param.name; });

/// Its creases lie one on the other and in a line, and hold faces without area.
TEST(FoldedFlat, TrianglesHaveAnArea)
{
	for (const std::uint32_t seed : {1u, 2u}) {
		Random       random(seed);
		TriangleMesh flat = noisySphere(4, 0.1, random);
		for (Vec3d& p : flat.positions)
			p.z = 0;
		RemeshOptions options;
		options.targetPercent = 50;
		const RemeshResult r  = remesh(flat.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(factsOf(r.mesh).complaints(), "");
	}
}

} // namespace gpr::test
