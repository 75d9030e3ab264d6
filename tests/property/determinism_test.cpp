// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The same input, options and seed give the same bytes, whatever the number of threads.

#include <tests/support/mesh_builders.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <cstring>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

RemeshResult run(const TriangleMesh& mesh, double percent, std::uint32_t seed, int threads)
{
	RemeshOptions options;
	options.targetPercent = percent;
	options.seed          = seed;
	options.threads       = threads;
	return remesh(mesh.view(), options);
}

bool sameBytes(const RemeshResult& a, const RemeshResult& b)
{
	const auto& p = a.mesh.positions;
	const auto& q = b.mesh.positions;
	if (p.size() != q.size() || a.mesh.triangles != b.mesh.triangles) return false;
	if (a.surfacePoints.size() != b.surfacePoints.size()) return false;
	return std::memcmp(p.data(), q.data(), p.size() * sizeof(Vec3d)) == 0 &&
		   std::memcmp(a.surfacePoints.data(), b.surfacePoints.data(),
					   a.surfacePoints.size() * sizeof(BarycentricPoint)) == 0;
}

struct Shape {
	const char*  name;
	TriangleMesh mesh;
	double       percent;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

/// Large enough for several blocks, so several threads have work.
std::vector<Shape> shapes()
{
	Random random(1);
	return {{"sphere", icosphere(5), 10},
			{"torus", torus(160, 80), 20},
			{"gridWithHoles", withHoles(jitteredGrid(80, 0.3, random), 4, random), 15},
			{"fineResult", icosphere(4), 200},
			{"twoSheets", twoSheets(50, 0.02), 30},
			{"repaired", damaged(icosphere(4), 40, random), 30},
			{"soup", soupOf(icosphere(4), 0, random), 20}};
}

class Determinism : public ::testing::TestWithParam<Shape> {};

TEST_P(Determinism, AnyNumberOfThreadsGivesTheSameBytes)
{
	const RemeshResult one = run(GetParam().mesh, GetParam().percent, 1, 1);
	ASSERT_EQ(one.status, Status::Ok) << one.message;
	for (int threads = 1; threads <= 4; ++threads)
		EXPECT_TRUE(sameBytes(run(GetParam().mesh, GetParam().percent, 1, threads), one))
			<< threads;
}

INSTANTIATE_TEST_SUITE_P(, Determinism, ::testing::ValuesIn(shapes()),
						 [](const auto& shape) { return std::string(shape.param.name); });

TEST(Seed, AnotherSeedGivesAnotherMeshOnClosedSurfaces)
{
	for (const TriangleMesh& mesh : {icosphere(4), torus(90, 46), cube(20)}) {
		const RemeshResult one = run(mesh, 20, 1, 2);
		EXPECT_TRUE(sameBytes(run(mesh, 20, 1, 2), one));
		for (std::uint32_t seed : {2u, 3u, 4000000000u})
			EXPECT_FALSE(sameBytes(run(mesh, 20, seed, 2), one)) << "seed " << seed;
	}
}

/// The working frame's scale is a power of two: such a change of unit changes nothing else.
TEST(Unit, ScalingByAPowerOfTwoScalesEveryBit)
{
	const TriangleMesh mesh = torus(60, 30);
	const RemeshResult one  = run(mesh, 20, 1, 2);
	for (double factor : {0x1p-30, 0x1p-1, 0x1p10, 0x1p30}) {
		const RemeshResult other = run(scaled(mesh, factor), 20, 1, 2);
		ASSERT_EQ(other.mesh.vertexNum(), one.mesh.vertexNum());
		EXPECT_EQ(other.mesh.triangles, one.mesh.triangles);
		EXPECT_TRUE(other.mesh.positions == scaled(one.mesh, factor).positions) << factor;
	}
}

/// On open surfaces the front starts from the rim, so the seed must count elsewhere too.
TEST(Seed, AnotherSeedGivesAnotherMeshOnOpenSurfaces)
{
	Random random(1);
	for (const TriangleMesh& mesh :
		 {openCylinder(80, 80, 0.5, 1.5), grid(100, 100), jitteredGrid(80, 0.3, random)}) {
		const RemeshResult one = run(mesh, 10, 1, 2);
		for (std::uint32_t seed : {2u, 3u, 4u})
			EXPECT_FALSE(sameBytes(run(mesh, 10, seed, 2), one)) << "seed " << seed;
	}
}

} // namespace

} // namespace gpr::test
