// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

TEST(NearestOnMesh, FindsWhatComparingAllFacesFinds)
{
	Random  random(1);
	Workers workers(2, nullptr);
	for (const TriangleMesh& mesh :
		 {noisySphere(3, 0.2, random), thinPlate(10, 0.01), grid(1, 1)}) {
		const HalfEdgeMesh  m = halfEdgesOf(mesh);
		const NearestOnMesh tree(m, workers);
		for (int i = 0; i < 200; ++i) {
			const Vec3d p(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
			const SurfacePoint a = tree.nearest(Vec3f(p));
			ASSERT_GE(a.face, 0);
			EXPECT_NEAR(length(Vec3d(a.position) - p), distanceToMesh(mesh, p), 1e-5);
			const std::int32_t* t = &mesh.triangles[3 * a.face];
			EXPECT_LT(distanceToTriangle(Vec3d(a.position), mesh.positions[t[0]],
										 mesh.positions[t[1]], mesh.positions[t[2]]),
					  1e-5);
		}
	}
}

TEST(NearestOnMesh, OfFacesEquallyNearIsThatOfTheLowestIndex)
{
	Workers       workers(2, nullptr);
	HalfEdgeMesh  m = halfEdgesOf(grid(8, 8));
	NearestOnMesh tree(m, workers);
	for (int v = 0; v < m.vertexNum; ++v) {
		const int lowest =
			int(std::find(m.origin.begin(), m.origin.end(), v) - m.origin.begin()) / 3;
		EXPECT_EQ(tree.nearest(m.position[v]).face, lowest) << v;
	}
}

TEST(NearestOnMesh, HasNoFaceForWhatIsNotFinite)
{
	Workers             workers(1, nullptr);
	const HalfEdgeMesh  m = halfEdgesOf(grid(2, 2)), none;
	const NearestOnMesh tree(m, workers);
	EXPECT_EQ(tree.nearest({NAN, 0, 0}).face, -1);
	EXPECT_EQ(tree.nearest({0, 0, NAN}).face, -1);
	EXPECT_EQ(tree.nearest({0, INFINITY, 0}).face, -1);
	EXPECT_EQ(NearestOnMesh(none, workers).nearest({0, 0, 0}).face, -1);
}

TEST(NearestOnTriangle, AgreesWithTheOracle)
{
	Random random(2);
	for (int i = 0; i < 2000; ++i) {
		const auto point = [&] {
			return Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
		};
		const Vec3d a = point(), b = point(), p = point() * 2.0;
		const Vec3d c = point();
		if (length(cross(b - a, c - a)) < 0.02) continue; // needles say little in single precision
		const Vec3f q = nearestOnTriangle(Vec3f(p), Vec3f(a), Vec3f(b), Vec3f(c));
		EXPECT_NEAR(length(Vec3d(q) - p), distanceToTriangle(p, a, b, c), 2e-4);
	}
}

TEST(NearestOnTriangle, IsRightForTrianglesWithoutArea)
{
	Random     random(2);
	const auto point = [&] {
		return Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
	};
	for (int i = 0; i < 4000; ++i) {
		const Vec3d a = point(), b = point(), p = point() * 2.0;
		const Vec3d c = a + (b - a) * random.between(-1, 2);
		const Vec3f q = nearestOnTriangle(Vec3f(p), Vec3f(a), Vec3f(b), Vec3f(c));
		EXPECT_LE(length(Vec3d(q) - p), distanceToTriangle(p, a, b, c) + 1e-3);
	}
}

} // namespace

} // namespace gpr::test
