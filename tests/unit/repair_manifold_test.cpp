// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/mesh_zoo.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/input/repair_manifold.h>
#include <vcg_extras/core/mesh/connect.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

struct Repaired {
	CleanCounts  counts;
	TriangleMesh before, after;
	bool         connects = false;

	explicit Repaired(const TriangleMesh& mesh)
	{
		Workers     workers(1, nullptr);
		IndexedMesh m = loaded(mesh, workers);
		before        = meshOf(m);
		repairManifold(m, workers, counts);
		after = meshOf(m);
		Buffer<int> faceStart;
		Surface     surface;
		surface.grid = orderSpatially(m, workers, faceStart);
		connects     = connect(m, faceStart, workers, surface);
	}
};

/// What a repair owes whatever was wrong.
void expectManifold(const Repaired& r)
{
	EXPECT_TRUE(r.connects);
	EXPECT_TRUE(factsOf(r.after).isManifold()) << factsOf(r.after).complaints();
}

class RepairZoo : public ::testing::TestWithParam<ZooMesh> {};

TEST_P(RepairZoo, LeavesManifoldsAloneAndMakesTheOthersManifold)
{
	const Repaired r(GetParam().mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.changedInput(), !GetParam().isManifold);
	if (GetParam().isManifold) {
		EXPECT_EQ(r.after.triangles, r.before.triangles);
	}
	else if (r.counts.duplicateFaces == 0) {
		EXPECT_NEAR(factsOf(r.after).area, factsOf(r.before).area, 1e-6) << "nothing is lost";
	}
}

INSTANTIATE_TEST_SUITE_P(, RepairZoo, ::testing::ValuesIn(meshZoo()),
						 zooName<::testing::TestParamInfo<ZooMesh>>);

TEST(RepairManifold, DropsDuplicateFacesWhateverTheirOrder)
{
	TriangleMesh mesh = grid(3, 3);
	const auto   t    = mesh.triangles;
	mesh.triangles.insert(mesh.triangles.end(), {t[1], t[2], t[0], t[5], t[4], t[3]});
	const Repaired r(mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.duplicateFaces, 2);
	EXPECT_EQ(r.after.triangles, std::vector<std::int32_t>(t.begin(), t.end()));
}

/// Two faces go straight on from each other, but run along the edge the same way: joined, one of
/// them would be turned over. The third one at 90° runs against both.
TEST(RepairManifold, KeepsFacesTogetherThatAreOrientedAlike)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}};
	mesh.triangles = {0, 1, 2, 0, 1, 3, 1, 0, 4};
	const Repaired r(mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.nonManifoldEdges, 1);
	EXPECT_EQ(r.counts.reorientedFaces, 0);
}

///  Seen along the edge: 0° and 180° go straight on, the fin at 90° is cut off.
TEST(RepairManifold, KeepsTheSmoothestPairOfAFinnedEdgeTogether)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-1, 0, 0.5}, {0, 1, 0.5}};
	mesh.triangles = {0, 1, 2, 0, 1, 4, 1, 0, 3};
	const Repaired r(mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.nonManifoldEdges, 1);
	const SurfaceFacts facts = factsOf(r.after);
	EXPECT_EQ(facts.components, 2);
	EXPECT_EQ(facts.borderEdges, 7) << "a pair with four, a fin with three";
	// The pair still shares an edge: faces 0 and 2 have two vertices in common.
	const auto& t      = r.after.triangles;
	int         shared = 0;
	for (int k = 0; k < 3; ++k)
		shared += std::count(t.begin() + 6, t.begin() + 9, t[k]);
	EXPECT_EQ(shared, 2);
}

TEST(RepairManifold, ManyFinsPairUp)
{
	for (int fins = 3; fins <= 12; ++fins) {
		const Repaired r(finsOnEdge(fins));
		expectManifold(r);
		EXPECT_EQ(r.counts.nonManifoldEdges, 1);
		EXPECT_EQ(factsOf(r.after).components, (fins + 1) / 2);
		EXPECT_NEAR(factsOf(r.after).area, factsOf(r.before).area, 1e-5);
	}
}

TEST(RepairManifold, OrientsAlikeTheSideWithMoreAreaWins)
{
	Random       random(11);
	TriangleMesh mesh   = icosphere(2);
	int          turned = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		if (!random.chance(0.3)) continue;
		std::swap(mesh.triangles[3 * f + 1], mesh.triangles[3 * f + 2]);
		++turned;
	}
	const Repaired r(mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.reorientedFaces, turned);
	const TriangleMesh good = icosphere(2);
	for (std::size_t f = 0; f < good.faceNum(); ++f) {
		const auto at = good.triangles.begin() + long(3 * f);
		const bool turnedBack =
			std::is_permutation(at, at + 3, r.after.triangles.begin() + long(3 * f));
		EXPECT_TRUE(turnedBack);
	}
	EXPECT_EQ(factsOf(r.after).againstEachOther, 0);
}

TEST(RepairManifold, GivesEachFanAVertexOfItsOwn)
{
	for (int fans = 2; fans <= 5; ++fans) {
		const Repaired r(fansSharingVertex(fans));
		expectManifold(r);
		EXPECT_EQ(r.counts.nonManifoldVertices, fans - 1);
		EXPECT_EQ(r.after.vertexNum(), r.before.vertexNum() + std::size_t(fans) - 1);
		EXPECT_EQ(factsOf(r.after).components, fans);
		EXPECT_DOUBLE_EQ(factsOf(r.after).area, factsOf(r.before).area);
	}
}

TEST(RepairManifold, CutsAMoebiusStripOpen)
{
	const Repaired r(moebiusStrip(24, 3));
	expectManifold(r);
	EXPECT_GE(r.counts.nonOrientableCuts, 3) << "a cut across is at least three edges long";
	EXPECT_LE(r.counts.nonOrientableCuts, 6) << "and along diagonals twice that at most";
	EXPECT_EQ(factsOf(r.after).components, 1);
	EXPECT_EQ(factsOf(r.after).boundaryLoops, 1) << "a strip cut through is a disk";
	EXPECT_EQ(factsOf(r.after).euler(), 1);
	EXPECT_NEAR(factsOf(r.after).area, factsOf(r.before).area, 1e-5);
}

TEST(RepairManifold, CutsAKleinBottleOpen)
{
	const Repaired r(kleinBottle(24, 12));
	expectManifold(r);
	EXPECT_GT(r.counts.nonOrientableCuts, 0);
	EXPECT_EQ(factsOf(r.after).components, 1);
	EXPECT_GT(factsOf(r.after).boundaryLoops, 0);
	EXPECT_NEAR(factsOf(r.after).area, factsOf(r.before).area, 1e-5);
}

class RepairRandom : public ::testing::TestWithParam<std::uint32_t> {};

/// The one promise that holds for any list of triangles: the result is manifold, lies where the
/// input lay, and faces go only as duplicates.
TEST_P(RepairRandom, AnythingBecomesManifold)
{
	Random random(GetParam());
	SCOPED_TRACE("seed " + std::to_string(GetParam()));
	for (int round = 0; round < 10; ++round) {
		const TriangleMesh base = round % 2 == 0 ? icosphere(1 + round % 3) : grid(3 + round, 4);
		const TriangleMesh mesh = damaged(base, 1 + random.below(40), random);
		const Repaired     r(mesh);
		expectManifold(r);
		EXPECT_GE(r.after.faceNum() + std::size_t(r.counts.duplicateFaces), r.before.faceNum());
		if (r.counts.duplicateFaces == 0) {
			EXPECT_NEAR(factsOf(r.after).area, factsOf(r.before).area, 1e-4);
		}
	}
}

/// A handful of vertices and random faces over them: everything that can go wrong goes wrong at
/// once.
TEST_P(RepairRandom, CrowdsOfFacesOverFewVerticesBecomeManifold)
{
	Random random(GetParam());
	SCOPED_TRACE("seed " + std::to_string(GetParam()));
	for (int round = 0; round < 30; ++round) {
		TriangleMesh mesh;
		const int    n = 4 + random.below(6);
		for (int v = 0; v < n; ++v)
			mesh.positions.push_back(
				{double(random.below(4)), double(random.below(4)), random.unit()});
		for (int f = 2 + random.below(25); f > 0; --f) {
			const int a = random.below(n), b = random.below(n), c = random.below(n);
			if (a != b && b != c && c != a) mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
		}
		if (mesh.faceNum() == 0) continue;
		expectManifold(Repaired(mesh));
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, RepairRandom, ::testing::ValuesIn(testSeeds(10)));

} // namespace

} // namespace gpr::test
