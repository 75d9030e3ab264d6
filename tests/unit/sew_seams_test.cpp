// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/input/sew_seams.h>
#include <vcg_extras/core/mesh/same_place.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

struct Sewn {
	CleanCounts  counts;
	TriangleMesh before, after;
	IndexedMesh  mesh;

	explicit Sewn(const TriangleMesh& cut, int threads = 1)
	{
		Workers workers(threads, nullptr);
		mesh   = loaded(cut, workers);
		before = meshOf(mesh);
		sewSeams(mesh, workers, counts);
		after = meshOf(mesh);
	}
};

/// Cuts a mesh at x = 0.5, or at y = 0.5.
TriangleMesh cutByPlanes(const TriangleMesh& mesh, bool alongX, bool alongY)
{
	std::vector<int> part;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const Vec3d middle = middleOf(mesh, f);
		part.push_back(int(alongX && middle.x > 0.5) + 2 * int(alongY && middle.y > 0.5));
	}
	return cutApart(mesh, part);
}

TEST(SewSeams, TwoHalvesOfASquareBecomeOne)
{
	const Sewn r(cutByPlanes(grid(4, 4), true, false));
	EXPECT_EQ(factsOf(r.before).components, 2);
	EXPECT_TRUE(isSoundSurface(r.after));
	EXPECT_TRUE(hasSameTopology(r.after, grid(4, 4)));
	EXPECT_EQ(r.counts.sewnEdges, 4);
	EXPECT_EQ(r.counts.sharedBorderEdges, 0);
	EXPECT_EQ(r.mesh.vertexNum, 25);
}

TEST(SewSeams, FourPartsThatMeetInAPointGetOneVertexThere)
{
	const Sewn r(cutByPlanes(grid(4, 4), true, true));
	EXPECT_EQ(factsOf(r.before).components, 4);
	EXPECT_TRUE(isSoundSurface(r.after));
	EXPECT_TRUE(hasSameTopology(r.after, grid(4, 4)));
	EXPECT_EQ(r.counts.sewnEdges, 8);
	EXPECT_EQ(r.mesh.vertexNum, 25);
}

TEST(SewSeams, ACubeOfSixSidesBecomesClosed)
{
	const Sewn r(cubeOfSides(3));
	EXPECT_EQ(factsOf(r.before).components, 6);
	EXPECT_TRUE(isSoundSurface(r.after));
	EXPECT_TRUE(hasSameTopology(r.after, cube(3)));
	EXPECT_EQ(r.counts.sewnEdges, 12 * 3);
}

TEST(SewSeams, FacesKeepTheirOrderTheirSourcesAndTheirPlace)
{
	const Sewn r(cubeOfSides(2));
	ASSERT_EQ(r.after.faceNum(), r.before.faceNum());
	for (std::size_t c = 0; c < r.before.triangles.size(); ++c) {
		EXPECT_EQ(r.mesh.sourceFace[c / 3], int(c / 3));
		const Vec3d was = r.before.positions[std::size_t(r.before.triangles[c])];
		EXPECT_EQ(length(r.after.positions[std::size_t(r.after.triangles[c])] - was), 0);
	}
}

TEST(SewSeams, AClosedMeshAndOneWithoutSeamsStayAsTheyAre)
{
	for (const TriangleMesh& mesh :
		 {icosphere(2), grid(5, 3), twoSheets(3, 0.01), squareFrame(6, 2), moebiusStrip(30, 3),
		  fansSharingVertex(3)}) {
		const Sewn r(mesh);
		EXPECT_EQ(r.after.triangles, r.before.triangles);
		EXPECT_FALSE(r.counts.changedInput());
		EXPECT_EQ(r.counts.sharedBorderEdges, 0);
	}
}

TEST(SewSeams, WhatIsNearerThanAMillionthOfTheBoxIsAtOnePlace)
{
	for (double gap : {0.0, 4e-7, 4e-6}) {
		const TriangleMesh cut = joined(grid(4, 4), shifted(grid(4, 4), {1 + gap, gap / 2, 0}));
		const Sewn         r(cut);
		const bool         isNear = gap < 1e-6;
		EXPECT_EQ(r.counts.sewnEdges, isNear ? 4 : 0) << gap;
		EXPECT_EQ(factsOf(r.after).components, isNear ? 1 : 2) << gap;
		EXPECT_TRUE(isSoundSurface(r.after));
	}
}

/// Two sides of a border with different numbers of vertices: such a border is no seam.
TEST(SewSeams, ABorderIsSewnWhereItCoincidesEdgeByEdge)
{
	const Sewn tees(joined(grid(2, 2), shifted(grid(2, 3), {1, 0, 0})));
	EXPECT_EQ(tees.counts.sewnEdges, 0);
	EXPECT_EQ(tees.after.triangles, tees.before.triangles);
	// The right square is half as high: two of the four edges have a partner.
	const Sewn part(joined(grid(4, 4), shifted(grid(2, 2, 0.5, 0.5), {1, 0.25, 0})));
	EXPECT_EQ(part.counts.sewnEdges, 2);
	EXPECT_TRUE(isSoundSurface(part.after));
	EXPECT_EQ(factsOf(part.after).components, 1);
	EXPECT_EQ(factsOf(part.after).boundaryLoops, 1);
}

TEST(SewSeams, PartsThatOnlyTouchInAPointStayApart)
{
	const Sewn r(joined(grid(2, 2), shifted(grid(2, 2), {1, 1, 0})));
	EXPECT_EQ(r.counts.sewnEdges, 0);
	EXPECT_EQ(r.after.triangles, r.before.triangles);
}

TEST(SewSeams, WhereMoreThanTwoMeetTheyStayCutAtTheSameNumbers)
{
	const double third = 2 * std::acos(-1.0) / 3;
	for (int pageNum : {3, 4, 5}) {
		TriangleMesh book = page(4, 0);
		for (int i = 1; i < pageNum; ++i)
			book = joined(book, shifted(page(4, i * third * 3 / pageNum), {0, 1e-7 * i, 0}));
		const Sewn r(book);
		EXPECT_EQ(r.counts.sewnEdges, 0);
		EXPECT_EQ(r.counts.sharedBorderEdges, 4 * pageNum);
		EXPECT_EQ(factsOf(r.after).components, pageNum);
		EXPECT_TRUE(isSoundSurface(r.after));
		std::set<std::array<float, 3>> places;
		int                            onAxis = 0;
		for (int v = 0; v < r.mesh.vertexNum; ++v) {
			const Vec3f p = r.mesh.position[v];
			if (std::abs(p.x) > 1e-4f || std::abs(p.y) > 1e-4f) continue;
			++onAxis;
			places.insert({p.x, p.y, p.z});
		}
		EXPECT_EQ(onAxis, 5 * pageNum);
		EXPECT_EQ(places.size(), 5u);
	}
}

TEST(SewSeams, SheetsThatLieOnOneAnotherAreNotJoined)
{
	// A sheet with two sides, as in games; the same sheet twice; and a sheet with other diagonals.
	const TriangleMesh sheet  = grid(4, 4);
	TriangleMesh       mirror = sheet;
	for (Vec3d& p : mirror.positions)
		p.x = 1 - p.x;
	for (const TriangleMesh& other : {insideOut(sheet), sheet, mirror}) {
		const Sewn r(joined(sheet, other));
		EXPECT_EQ(r.counts.sewnEdges, 0);
		EXPECT_EQ(r.counts.sharedBorderEdges, 2 * 16);
		EXPECT_EQ(r.after.triangles, r.before.triangles);
	}
}

TEST(SewSeams, PartsThatAreTheOtherWayRoundAreSewnWhereTurningThemHelps)
{
	TriangleMesh cut = cutByPlanes(grid(6, 6), true, false);
	// Turn the right half over.
	for (std::size_t f = 0; f < cut.faceNum(); ++f) {
		const std::size_t c = 3 * f;
		if (cut.positions[std::size_t(cut.triangles[c])].x +
				cut.positions[std::size_t(cut.triangles[c + 1])].x +
				cut.positions[std::size_t(cut.triangles[c + 2])].x >
			1.5)
			std::swap(cut.triangles[c + 1], cut.triangles[c + 2]);
	}
	Sewn r(cut);
	EXPECT_EQ(r.counts.sewnEdges, 6);
	Workers workers(1, nullptr);
	repair(r.mesh, workers, r.counts);
	EXPECT_TRUE(isSoundSurface(meshOf(r.mesh)));
	EXPECT_TRUE(hasSameTopology(meshOf(r.mesh), grid(6, 6)));
	EXPECT_EQ(r.counts.reorientedFaces, 36);
	EXPECT_EQ(r.counts.nonOrientableCuts, 0);
}

/// The ends of a strip with one twist lie at the same place, but no turning of faces makes the ends
/// fit.
TEST(SewSeams, AOneSidedStripStaysCut)
{
	TriangleMesh strip = moebiusStrip(40, 3);
	for (Vec3d& p : strip.positions)
		p += Vec3d(0.5, 0.5, 0); // cut at x = 0.5 and y = 0.5
	const Sewn r(cutByPlanes(strip, true, true));
	EXPECT_EQ(factsOf(r.before).components, 4);
	EXPECT_EQ(r.counts.sewnEdges, 3 * 3);
	EXPECT_EQ(r.counts.sharedBorderEdges, 2 * 3);
	EXPECT_EQ(factsOf(r.after).components, 1);
	EXPECT_EQ(factsOf(r.after).boundaryLoops, 1);
	EXPECT_EQ(factsOf(r.after).crowdedEdges, 0);
}

TEST(SewSeams, SingleFacesBecomeASurface)
{
	for (const TriangleMesh& mesh : {icosphere(0), icosphere(1), cube(1), lPrism(1), torus(5, 4)}) {
		std::vector<int> part(mesh.faceNum());
		for (std::size_t f = 0; f < part.size(); ++f)
			part[f] = int(f);
		const Sewn r(cutApart(mesh, part));
		EXPECT_TRUE(isSoundSurface(r.after));
		EXPECT_TRUE(hasSameTopology(r.after, mesh));
	}
}

/// Two bent sheets with the same rim and an edge across at the same place: after sewing the rim,
/// this edge would have four faces.
TEST(SewSeams, NoEdgeGetsMoreThanTwoFaces)
{
	TriangleMesh lens;
	lens.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
	lens.triangles = {0, 1, 2, 0, 2, 3};
	TriangleMesh other;
	other.positions = {{0, 0, 0}, {1, 0, 0},       {1, 1, 0},
					   {0, 1, 0}, {0.7, 0.3, 0.4}, {0.3, 0.7, 0.4}};
	other.triangles = {1, 0, 4, 2, 1, 4, 0, 2, 4, 3, 2, 5, 0, 3, 5, 2, 0, 5};
	const Sewn r(joined(lens, other));
	EXPECT_TRUE(factsOf(r.after).isManifold()) << factsOf(r.after).complaints();
	EXPECT_EQ(factsOf(r.after).crowdedEdges, 0);
	EXPECT_GT(r.counts.sharedBorderEdges, 0);
}

/// Parts twice at the same place, the right way round or turned over, and missing parts.
TriangleMesh withPartsTwice(const TriangleMesh& mesh, const std::vector<int>& part, Random& random)
{
	TriangleMesh     all;
	std::vector<int> partOfAll;
	const int        partNum = *std::max_element(part.begin(), part.end()) + 1;
	all.positions            = mesh.positions;
	for (int p = 0; p < partNum; ++p) {
		const int copies = random.chance(0.1) ? 0 : random.chance(0.2) ? 2 + random.below(2) : 1;
		for (int copy = 0; copy < copies; ++copy) {
			const bool isTurned = random.chance(0.15);
			for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
				if (part[f] != p) continue;
				const std::int32_t* t = &mesh.triangles[3 * f];
				all.triangles.insert(all.triangles.end(),
									 {t[0], t[isTurned ? 2 : 1], t[isTurned ? 1 : 2]});
				partOfAll.push_back(3 * p + copy);
			}
		}
	}
	return cutApart(all, partOfAll);
}

/// Whatever parts lie at the same place, an edge never gets a third face, and a vertex no second
/// fan.
TEST(SewSeams, RandomPartsStayManifold)
{
	for (std::uint32_t seed : testSeeds(150)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random             random(seed);
		const TriangleMesh whole = randomSurface(random);
		const int          most  = std::max(2, int(whole.faceNum()) / (1 + random.below(40)));
		const auto         part  = randomParts(whole, 1 + random.below(most), random);
		TriangleMesh       cut   = withPartsTwice(whole, part, random);
		if (cut.faceNum() < 2) continue;
		for (Vec3d& p : cut.positions)
			p.x += random.between(0, 2e-7);
		Sewn r(shuffled(cut, random));
		ASSERT_EQ(r.after.faceNum(), r.before.faceNum());
		const SurfaceFacts facts = factsOf(r.after);
		EXPECT_EQ(facts.crowdedEdges, 0);
		EXPECT_EQ(facts.repeatedCorners, 0);
		Workers     workers(1, nullptr);
		IndexedMesh unsewn = loaded(r.before, workers);
		CleanCounts counts, before;
		repair(unsewn, workers, before);
		repair(r.mesh, workers, counts);
		EXPECT_EQ(counts.nonManifoldEdges, 0);
		EXPECT_LE(counts.nonManifoldVertices, before.nonManifoldVertices)
			<< "parts touch themselves";
		EXPECT_EQ(counts.nonOrientableCuts, 0);
		EXPECT_EQ(counts.duplicateFaces, 0);
		EXPECT_TRUE(factsOf(meshOf(r.mesh)).isManifold()) << factsOf(meshOf(r.mesh)).complaints();
	}
}

TEST(SewSeams, AnyNumberOfThreadsMakesTheSame)
{
	Random             random(5);
	const TriangleMesh ball = icosphere(4);
	const TriangleMesh cut  = cutApart(ball, randomParts(ball, 40, random));
	const Sewn         one(cut, 1), three(cut, 3);
	EXPECT_EQ(one.after.triangles, three.after.triangles);
	EXPECT_EQ(one.counts.sewnEdges, three.counts.sewnEdges);
	EXPECT_TRUE(hasSameTopology(one.after, ball));
}

TEST(SamePlaceTable, FindsTheLeastNumberWithinReach)
{
	SamePlaceTable table(10);
	const Vec3f    p(0.25f, -0.5f, 16e-6f);
	EXPECT_EQ(table.findOrPut(p, 7), 7);
	EXPECT_EQ(table.findOrPut(p + Vec3f(5e-7f, 0, -5e-7f), 9), 7) << "over the border of a cell";
	EXPECT_EQ(table.findOrPut(p + Vec3f(0, 0, 2e-6f), 3), 3);
	EXPECT_EQ(table.findOrPut(p + Vec3f(0, 0, 9e-7f), 12), 7);
	EXPECT_EQ(table.findOrPut(p + Vec3f(0, 0, 1.5e-6f), 13), 3);
}

} // namespace

} // namespace gpr::test
