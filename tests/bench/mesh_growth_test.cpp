// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <vcg_extras/bench/built_in_meshes.h>
#include <vcg_extras/bench/mesh_growth.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

using bench::growMesh;
using bench::MeshGrowth;

TEST(MeshGrowth, ClosedMeshesGetAsManyFacesAsWanted)
{
	const TriangleMesh base = icosphere(1);
	for (const int wanted : {82, 100, 320, 1000, 5000}) {
		const TriangleMesh grown = growMesh(base, wanted, MeshGrowth());
		EXPECT_EQ(int(grown.faceNum()), wanted);
		EXPECT_TRUE(isSoundSurface(grown));
		EXPECT_TRUE(hasSameTopology(base, grown));
	}
}

TEST(MeshGrowth, AMeshThatHasEnoughFacesStaysAsItIs)
{
	const TriangleMesh base  = icosphere(2);
	const TriangleMesh grown = growMesh(base, 10, MeshGrowth());
	EXPECT_EQ(grown.triangles, base.triangles);
	EXPECT_TRUE(grown.positions == base.positions);
}

TEST(MeshGrowth, BordersAndHandlesStay)
{
	for (const TriangleMesh& base : {squareFrame(6, 2), torus(8, 6), openCylinder(8, 3, 1, 2)}) {
		const TriangleMesh grown = growMesh(base, 3000, MeshGrowth());
		EXPECT_NEAR(double(grown.faceNum()), 3000, 2);
		EXPECT_TRUE(isSoundSurface(grown));
		EXPECT_TRUE(hasSameTopology(base, grown));
	}
}

TEST(MeshGrowth, EdgesOfManyFacesAreSplitInAllOfThem)
{
	const TriangleMesh base  = finsOnEdge(3);
	const SurfaceFacts facts = factsOf(growMesh(base, 12, MeshGrowth()));
	EXPECT_EQ(facts.faces, 12);
	EXPECT_EQ(facts.crowdedEdges, 2) << "both halves of the edge the fins share";
	EXPECT_EQ(facts.components, 1);
}

TEST(MeshGrowth, VerticesRiseNoFurtherThanTheRoughnessAllows)
{
	MeshGrowth rough;
	rough.roundness          = 0;
	rough.roughness          = 0.1;
	const TriangleMesh grown = growMesh(grid(1, 1), 8, rough);
	double             top   = 0;
	for (const Vec3d& p : grown.positions)
		top = std::max(top, std::abs(p.z));
	EXPECT_GT(top, 0);
	EXPECT_LE(top, 0.1 * std::sqrt(2.0)) << "of the diagonal, the longest edge";
}

TEST(MeshGrowth, RoundMidpointsOfACoarseSphereLieNearIt)
{
	MeshGrowth smooth;
	smooth.roughness         = 0;
	smooth.jitter            = 0;
	const TriangleMesh base  = icosphere(1);
	const TriangleMesh grown = growMesh(base, 4 * std::int64_t(base.faceNum()), smooth);
	for (const Vec3d& p : grown.positions)
		EXPECT_NEAR(length(p), 1, 0.005) << "midpoints of the edges lie 0.03 and more inside";
}

TEST(MeshGrowth, TheSeedDecides)
{
	MeshGrowth         first, second;
	const TriangleMesh base = icosphere(1);
	second.seed             = 2;
	EXPECT_TRUE(growMesh(base, 500, first).positions == growMesh(base, 500, first).positions);
	EXPECT_FALSE(growMesh(base, 500, first).positions == growMesh(base, 500, second).positions);
}

TEST(BuiltInMeshes, AreSound)
{
	EXPECT_TRUE(isSoundSurface(bench::roughStone(20000)));
	EXPECT_TRUE(isSoundSurface(bench::sharpBox(20000)));
	EXPECT_EQ(factsOf(bench::roughStone(20000)).boundaryLoops, 0);
	const TriangleMesh land = bench::roughLand(20000);
	EXPECT_TRUE(isSoundSurface(land));
	EXPECT_EQ(factsOf(land).boundaryLoops, 1);
	TriangleMesh none;
	EXPECT_FALSE(bench::makeBuiltIn("pyramid", 100, none));
}

/// A box with rounded or dented sides would have no creases to find.
TEST(BuiltInMeshes, TheBoxIsFlat)
{
	for (const Vec3d& p : bench::sharpBox(5000).positions) {
		const double outside = std::max({-p.x, p.x - 1, -p.y, p.y - 0.7, -p.z, p.z - 0.4});
		EXPECT_NEAR(outside, 0, 1e-9);
	}
}

} // namespace

} // namespace gpr::test
