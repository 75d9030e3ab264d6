// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Counts below the need of a topology: refused, with the smallest possible count.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/run_options.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

RemeshOptions unsewn(std::int64_t vertexNum, std::uint32_t seed)
{
	RemeshOptions options = countOptions(vertexNum);
	options.seed          = seed;
	options.sew           = false; // sewing would close a slit
	return options;
}

struct Shape {
	const char*  name;
	TriangleMesh mesh;
	int          minPossible; ///< no triangulation of this topology has fewer vertices
	int          maxNamed;    ///< a smallest count above this would be a poor answer
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

/// A cube with a slit along two edges of the mesh on an edge of the cube: a border loop of four
/// vertices in a line.
TriangleMesh slitCube()
{
	TriangleMesh mesh = cube(8);
	double       most = mesh.positions[0].x;
	for (const Vec3d& p : mesh.positions)
		most = std::max(most, p.x);
	const auto isInside = [&](const Vec3d& p) { return p.x == most && p.y == most && p.z < most; };
	int        middle   = 0;
	for (int v = 0; v < int(mesh.vertexNum()); ++v) {
		const Vec3d &p = mesh.positions[v], &q = mesh.positions[middle];
		if (isInside(p) && (!isInside(q) || p.z > q.z)) middle = v;
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		std::int32_t* t        = &mesh.triangles[3 * f];
		const auto    isAtSide = [&](int v) { return mesh.positions[v].x == most; };
		if (std::all_of(t, t + 3, isAtSide)) std::replace(t, t + 3, middle, int(mesh.vertexNum()));
	}
	mesh.positions.push_back(mesh.positions[middle]);
	return mesh;
}

std::vector<Shape> shapes()
{
	Random random(1);
	return {{"sphere", icosphere(3), 4, 6},
			{"cube", cube(8), 4, 8},
			{"slitCube", slitCube(), 3, 6},
			{"torus", torus(40, 20), 7, 14},
			{"twoSpheres", joined(icosphere(3), shifted(icosphere(2), {3, 0, 0})), 8, 12},
			{"grid", grid(20, 20), 3, 4},
			{"cylinder", openCylinder(24, 24, 0.5, 1.5), 6, 9},
			{"gridWithHoles", withHoles(grid(30, 30), 2, random), 7, 18},
			{"twoSheets", twoSheets(15, 0.1), 6, 8}};
}

class SmallestCount : public ::testing::TestWithParam<Shape> {};

TEST_P(SmallestCount, IsNamedAndCanBeHad)
{
	const TriangleMesh& mesh = GetParam().mesh;
	for (std::uint32_t seed : {1u, 2u, 3u}) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		const RemeshResult refused = remesh(mesh.view(), unsewn(1, seed));
		ASSERT_EQ(refused.status, Status::CountTooSmall) << refused.message;
		EXPECT_EQ(refused.mesh.vertexNum(), 0u) << "nothing is exported";
		const std::int64_t smallest = refused.smallestVertexNum;
		EXPECT_GE(smallest, GetParam().minPossible);
		EXPECT_LE(smallest, GetParam().maxNamed);
		EXPECT_NE(refused.message.find(std::to_string(smallest)), std::string::npos)
			<< "the sentence names it: " << refused.message;

		const RemeshResult r = remesh(mesh.view(), unsewn(smallest, seed));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(std::int64_t(r.mesh.vertexNum()), smallest);
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
	}
}

TEST_P(SmallestCount, IsTakenWithAllowNearestAndForPercentages)
{
	const TriangleMesh& mesh    = GetParam().mesh;
	RemeshOptions       nearest = unsewn(1, 1);
	nearest.allowNearest        = true;
	RemeshOptions percent       = unsewn(0, 1);
	percent.targetMode          = TargetMode::Percent;
	percent.targetPercent       = 0.001;
	for (const RemeshOptions& options : {nearest, percent}) {
		const RemeshResult r = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_FALSE(r.notes.empty()) << "said so";
		EXPECT_GE(std::int64_t(r.mesh.vertexNum()), GetParam().minPossible);
		EXPECT_LE(std::int64_t(r.mesh.vertexNum()), GetParam().maxNamed);
		EXPECT_EQ(r.report.targetVertexNum, std::int64_t(r.mesh.vertexNum()));
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
	}
}

/// From the smallest count on, every count can be had: no gaps.
TEST_P(SmallestCount, EveryLargerCountIsHit)
{
	const TriangleMesh& mesh    = GetParam().mesh;
	const RemeshResult  refused = remesh(mesh.view(), unsewn(1, 1));
	ASSERT_EQ(refused.status, Status::CountTooSmall);
	for (std::int64_t n = refused.smallestVertexNum; n <= refused.smallestVertexNum + 30; ++n) {
		const RemeshResult r = remesh(mesh.view(), unsewn(n, 1));
		ASSERT_EQ(r.status, Status::Ok) << n << " vertices: " << r.message;
		EXPECT_EQ(std::int64_t(r.mesh.vertexNum()), n);
		EXPECT_TRUE(isSoundSurface(r.mesh)) << n << " vertices";
		EXPECT_TRUE(hasSameTopology(r.mesh, mesh)) << n << " vertices";
	}
}

INSTANTIATE_TEST_SUITE_P(, SmallestCount, ::testing::ValuesIn(shapes()),
						 [](const auto& shape) { return std::string(shape.param.name); });

/// A raised count loads the input again; faults of the input are counted once.
TEST(SmallestCountTells, TheInputsFaultsAreCountedOnce)
{
	TriangleMesh mesh = torus(40, 20);
	mesh.triangles.insert(mesh.triangles.end(), {0, 0, 1, 0, 1, 0});
	mesh.positions.push_back({7, 7, 7}); // in no face
	RemeshOptions options = unsewn(4, 1);
	options.allowNearest  = true;
	const RemeshResult r  = remesh(mesh.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_GT(r.mesh.vertexNum(), 4u);
	EXPECT_EQ(r.report.cleaned.repeatedIndexFaces, 2);
	EXPECT_EQ(r.report.cleaned.unreferencedVertices, 1);
}

/// With the smallest count itself, the outer border would end as a triangle.
TEST(SmallestCountTells, AWishBelowTheSmallestKeepsTheBorderOfAHoleySheet)
{
	for (std::uint32_t seed : {1u, 2u, 3u}) {
		Random       random(seed);
		TriangleMesh mesh = jitteredGrid(80, 0.3, random);
		TriangleMesh holey;
		holey.positions = mesh.positions;
		for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
			if (random.chance(0.02)) continue;
			holey.triangles.insert(holey.triangles.end(), &mesh.triangles[3 * f],
								   &mesh.triangles[3 * f] + 3);
		}
		RemeshOptions options = countOptions(0);
		options.targetMode    = TargetMode::Percent;
		options.targetPercent = 1;
		options.seed          = seed;
		const RemeshResult r  = remesh(holey.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const SurfaceFacts before = factsOf(holey), after = factsOf(r.mesh);
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_NEAR(after.area, before.area, 0.1 * before.area) << "seed " << seed;
	}
}

} // namespace

} // namespace gpr::test
