// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Splits and collapses for the last poor angles, and their tools: patches that can be restored, and
// the count of contacts round a patch.

#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/face_boxes.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/optimization/face_goals.h>
#include <vcg_extras/core/optimization/face_repair.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace gpr::test {

namespace {

/// A square, and a ribbon much narrower than the distance of its vertices.
OnSurface squareAndRibbon()
{
	TriangleMesh ribbon = grid(4, 1, 1, 0.06);
	for (Vec3d& p : ribbon.positions)
		p.y += 2;
	return OnSurface(joined(grid(16, 16), ribbon));
}

/// Returns whether the number of vertices or of splits and collapses changed.
bool repair(OnSurface& on, Workers& workers, std::int64_t targetNum)
{
	const std::int64_t before = on.result.splitNum + on.result.collapseNum;
	PoorFaces          wanted;
	wanted.target.vertexNum = targetNum;
	raiseSmallAngles(on.surface, on.boundary, wanted, on.result, workers);
	repairPoorFaces(on.surface, on.boundary, wanted, on.result, workers);
	return on.result.splitNum + on.result.collapseNum > before;
}

/// Moves and flips only.
void raiseAngles(OnSurface& on)
{
	const ClosestFaceMap map(on.surface, on.result, on.workers);
	Assignment           assignment(on.surface, map, numbersBelow(on.m().faceNum));
	std::int64_t         work = 100000000;
	LocalSearch          search(on.surface, on.boundary, &assignment, work, on.result, on.workers);
	search.run(smallAngles(search, 32 * radians));
}

std::vector<int> tableOf(const HalfEdgeMesh& m)
{
	std::vector<int> table(m.origin.data(), m.origin.data() + m.halfEdgeNum());
	table.insert(table.end(), m.opposite.data(), m.opposite.data() + m.halfEdgeNum());
	table.insert(table.end(), m.outgoing.data(), m.outgoing.data() + m.vertexNum);
	return table;
}

} // namespace

/// With few changes each changed face is looked at; with many, new boxes are made.
TEST(FacesInSpace, FindsFacesWhereTheyAreAfterAnyNumberOfChanges)
{
	Workers       workers(2, nullptr);
	OnSurface     on(grid(40, 40));
	HalfEdgeMesh& m = on.result.mesh;
	reserve(m, m.vertexNum + 10, m.faceNum + 20);
	for (const int changeNum : {5, 40, m.vertexNum / 2}) { // the tree is made anew for the last
		FacesInSpace space(m, workers);
		for (int v = 0; v < changeNum; ++v) {
			m.position[v].z += 1;
			space.follow(facesRound(m, {v}));
		}
		const int inside = 20 * 41 + 20, added = m.vertexNum++; // in the middle of the grid
		splitEdge(m, m.outgoing[inside], added);
		m.position[added] = m.position[inside] + Vec3f{0, 0, 3};
		space.follow(facesRound(m, {added}));
		for (int f = 0; f < m.faceNum; f += f < m.faceNum - 9 ? 7 : 1) {
			const Box<float>       box  = boxOfFace(m, f);
			const std::vector<int> near = space.near(box);
			for (int g = 0; g < m.faceNum; ++g) {
				const auto num = std::count(near.begin(), near.end(), g);
				if (boxOfFace(m, g).meets(box))
					ASSERT_EQ(num, 1) << f << " and " << g;
				else
					ASSERT_LE(num, 1) << f << " and " << g;
			}
		}
	}
}

/// Each claim at a hub looks at all its neighbours, so these walks are work, too.
TEST(LocalSearches, CountWalksRoundAHub)
{
	OnSurface    on(cone(5000, 1, 1, 1));
	std::int64_t work = 1000000;
	LocalSearch  search(on.surface, on.boundary, nullptr, work, on.result, on.workers);
	Goal         goal; // nothing to try
	goal.isBad           = [](int) { return true; };
	goal.faceCost        = [](int) { return 1.0f; };
	goal.budget.attempts = std::numeric_limits<std::int64_t>::max();
	EXPECT_FALSE(search.run(goal)) << work << " left";
}

/// A budget that is spent with the last bad face ends no search.
TEST(LocalSearches, TellABudgetOnlyIfItLeavesBadFaces)
{
	int  attempts = 0;
	bool isLeft   = true;
	for (; isLeft; ++attempts) {
		ASSERT_LT(attempts, 1000);
		TriangleMesh mesh = grid(12, 12);
		mesh.positions[45] += Vec3d(0.06, 0.05, 0);
		OnSurface    on(mesh);
		std::int64_t work = 100000000;
		LocalSearch  search(on.surface, on.boundary, nullptr, work, on.result, on.workers);
		Goal         goal    = smallAngles(search, 32 * radians);
		goal.budget.attempts = attempts;
		const bool isDone    = search.run(goal);
		isLeft               = !search.findBad(goal).empty();
		EXPECT_EQ(isDone, !isLeft) << attempts;
		work = 0;
		EXPECT_EQ(search.run(goal), !isLeft) << attempts;
	}
	EXPECT_GT(attempts, 2);
}

TEST(RepairPoorFaces, SplitsWhatMovesAndFlipsCannotRepair)
{
	OnSurface on = squareAndRibbon();
	raiseAngles(on);
	ASSERT_LT(on.minAngleDeg(), 20);
	const TriangleMesh before = meshOf(on.m());
	EXPECT_TRUE(repair(on, on.workers, 0));
	EXPECT_GT(on.minAngleDeg(), 30);
	EXPECT_GT(on.m().vertexNum, int(before.vertexNum()));
	EXPECT_TRUE(hasSameTopology(meshOf(on.m()), before));
	EXPECT_NEAR(factsOf(meshOf(on.m())).area / factsOf(before).area, 1, 1e-3);
	on.expectOnSurface();
	on.expectSound();
}

TEST(RepairPoorFaces, MakesTheCountGoodElsewhere)
{
	OnSurface on  = squareAndRibbon();
	const int num = on.m().vertexNum;
	raiseAngles(on);
	EXPECT_TRUE(repair(on, on.workers, num));
	EXPECT_EQ(on.m().vertexNum, num);
	EXPECT_GT(on.minAngleDeg(), 30);
	on.expectSound();
}

TEST(RepairPoorFaces, ChangesNoCountWhereTheWantedOneCannotBeReached)
{
	OnSurface on  = squareAndRibbon();
	const int num = on.m().vertexNum;
	EXPECT_FALSE(repair(on, on.workers, 1));
	EXPECT_EQ(on.m().vertexNum, num);
	on.expectSound();
}

/// Fewer vertices, down to a tetrahedron, would have better angles.
TEST(RepairPoorFaces, TakesNoOtherCountHoweverGoodTheAngles)
{
	for (const TriangleMesh& mesh :
		 {uvSphere(4, 16), uvSphere(8, 12), closedCylinder(20, 2, 1, 1), torus(20, 4)}) {
		OnSurface on(mesh);
		const int num = on.m().vertexNum;
		ASSERT_LT(on.minAngleDeg(), 32);
		repair(on, on.workers, 3);
		EXPECT_EQ(on.m().vertexNum, num);
	}
}

/// New vertices at the ribbon need collapses on the body, where each vertex counts.
TEST(RepairPoorFaces, LowersNoAngleAndInvertsNoFaceForOthers)
{
	for (const TriangleMesh& body : {cube(1), torus(5, 3, 0.25, 0.1)}) {
		OnSurface on(joined(grid(10, 1, 2.5, 0.12), shifted(body, {0, 3, 0})));
		raiseAngles(on);
		const double angle    = on.minAngleDeg();
		const int    inverted = invertedFaceNum(on.surface, on.result, on.workers);
		repair(on, on.workers, on.m().vertexNum);
		EXPECT_GE(on.minAngleDeg(), 0.9999 * angle);
		EXPECT_LE(invertedFaceNum(on.surface, on.result, on.workers), inverted);
	}
}

TEST(RepairPoorFaces, LeavesPinnedVerticesAndAKeptBorder)
{
	OnSurface on             = squareAndRibbon();
	on.result.keepsBorder    = true;
	const HalfEdgeMesh start = copyMesh(on.m(), on.workers);
	for (int v = 0; v < start.vertexNum; ++v)
		on.result.vertex[v].isPinned = start.isBorderVertex(v);
	repair(on, on.workers, start.vertexNum);
	int stayed = 0, border = 0;
	for (int v = 0; v < start.vertexNum; ++v)
		border += start.isBorderVertex(v);
	for (int v = 0; v < on.m().vertexNum; ++v)
		stayed += on.m().isBorderVertex(v) && on.result.vertex[v].isPinned;
	EXPECT_EQ(stayed, border);
	on.expectSound();
}

/// The last row of a square turned under: nothing of its width can be a triangle's.
TEST(RepairPoorFaces, GivesUpABorderTurnedUnder)
{
	TriangleMesh mesh = grid(16, 17, 1, 17.0 / 16);
	for (Vec3d& p : mesh.positions) {
		if (p.y > 1.01) p = {p.x, 1 - 0.01, -0.004};
	}
	OnSurface  on(mesh);
	const auto poorNum = [&] { return findPoorFaces(on.m(), 0.5f, on.workers).size(); };
	ASSERT_GE(poorNum(), 32u);
	EXPECT_TRUE(repair(on, on.workers, 0));
	EXPECT_LE(poorNum(), 6u) << "at the two corners, which stay";
	on.expectSound();
}

TEST(RepairPoorFaces, DoesNotDependOnThreads)
{
	TriangleMesh ribbon = grid(4, 1, 1, 0.06);
	expectSameForAnyThreads(
		ribbon, [](OnSurface& on, Workers& workers) { EXPECT_TRUE(repair(on, workers, 0)); });
}

/// On these meshes, no single change repairs the last few triangles, of 12° to 20°, at bumps.
TEST(RepairPoorFaces, TwoChangesInARowRepairWhatOneCannot)
{
	for (unsigned seed : {4u, 6u, 12u, 23u, 97u}) {
		Random             random(seed);
		const TriangleMesh mesh = noisySphere(5, 0.05, random);
		RemeshOptions      options;
		options.targetMode    = TargetMode::Percent;
		options.targetPercent = 8;
		options.adapt         = 0; // 32° without adaptivity; with it sizes would follow the noise
		const RemeshResult r  = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_GT(r.report.quality.minAngleDeg, 31.5) << seed;
	}
}

/// Whether the second of two vertices may go from height `from` to height `to`, while the first
/// vertex is `top` above the surface.
bool mayRise(OnSurface& on, float guarded, float top, float from, float to)
{
	constexpr float      enough = 1e-3f;
	const int            first = 40, second = 200;
	const ClosestFaceMap map(on.surface, on.result, on.workers);
	Assignment           assignment(on.surface, map, numbersBelow(on.m().faceNum));
	std::vector<int>     all(std::size_t(on.m().faceNum));
	std::iota(all.begin(), all.end(), 0);
	on.m().position[first].z += top;
	on.m().position[second].z += from;
	const PatchDistance before(assignment, all, trianglesOf(on.m(), all), enough, guarded);
	on.m().position[second].z += to - from;
	const bool keeps = before.isKeptBy(trianglesOf(on.m(), all));
	on.m().position[first].z -= top;
	on.m().position[second].z -= to;
	return keeps;
}

TEST(PatchDistance, LetsNoTipSinkBecauseAnotherOneHasSunkFarther)
{
	OnSurface       on(grid(16, 16));
	constexpr float guarded = 0.007f;
	EXPECT_FALSE(mayRise(on, guarded, 0.01f, 0.006f, 0.009f));
	EXPECT_FALSE(mayRise(on, guarded, 0.01f, 0.001f, 0.02f));
	EXPECT_TRUE(mayRise(on, guarded, 0.01f, 0.001f, 0.004f)) << "not far yet";
	EXPECT_TRUE(mayRise(on, HUGE_VALF, 0.01f, 0.006f, 0.009f));
	EXPECT_FALSE(mayRise(on, HUGE_VALF, 0.01f, 0.001f, 0.02f));
}

// ---- limits of the search

/// The vertex nearest to a place of the input.
int vertexNear(OnSurface& on, const Vec3d& place)
{
	const Vec3f p    = on.surface.frame.toWorking(place);
	int         best = 0;
	for (int v = 0; v < on.m().vertexNum; ++v) {
		if (squaredLength(on.m().position[v] - p) < squaredLength(on.m().position[best] - p))
			best = v;
	}
	return best;
}

/// A goal that draws one vertex two edges far in a direction, without a limit.
Goal drawnAlong(OnSurface& on, int v, const Vec3f& direction)
{
	const HalfEdgeMesh& m     = on.m();
	const Vec3f         start = m.position[v];
	const float         way   = 2 * on.result.idealEdge;
	const auto          hasIt = [&m, v](int f) {
        const int* c = &m.origin[3 * f];
        return c[0] == v || c[1] == v || c[2] == v;
	};
	Goal goal;
	goal.isBad    = hasIt;
	goal.faceCost = [=, &m](int f) {
		const float left = way - dot(m.position[v] - start, direction);
		return hasIt(f) ? std::max(0.0f, left / way) : 0.0f;
	};
	goal.operations  = {Operation::Move};
	goal.stepLengths = {0.25f};
	goal.settles     = false;
	return goal;
}

void search(OnSurface& on, const Goal& goal)
{
	std::int64_t work = 100000000;
	LocalSearch(on.surface, on.boundary, nullptr, work, on.result, on.workers).run(goal);
}

float leastAgreement(OnSurface& on)
{
	const Buffer<Vec3f> normal = smoothNormals(on.surface, on.result, on.workers);
	float               least  = 1;
	for (int f = 0; f < on.m().faceNum; ++f)
		least = std::min(least, normalAgreement(on.m(), normal, f));
	return least;
}

float leastAgreementAfterDrawing(float least)
{
	OnSurface on(arch());
	Goal      goal        = drawnAlong(on, vertexNear(on, {0, 2, 1}), {1, 0, 0});
	goal.limits.agreement = least;
	search(on, goal);
	return leastAgreement(on);
}

TEST(LocalSearch, OfManyFacesDoesNotDependOnThreads)
{
	Random             random(5);
	const TriangleMesh mesh = jitteredGrid(60, 0.45, random);
	expectSameForAnyThreads(mesh, [](OnSurface& on, Workers& workers) {
		const double before = on.minAngleDeg();
		std::int64_t work   = 100000000;
		LocalSearch  search(on.surface, on.boundary, nullptr, work, on.result, workers);
		Goal         goal   = smallAngles(search, 30 * radians);
		const auto   badNum = search.findBad(goal).size();
		ASSERT_GT(badNum, 100u) << "else nothing is tested";
		search.run(goal);
		EXPECT_LT(search.findBad(goal).size(), badNum / 4);
		EXPECT_GT(on.minAngleDeg(), before);
		on.expectSound();
	});
}

TEST(LocalSearch, TiltsNoFaceFartherFromTheSurfaceThanItMay)
{
	EXPECT_LT(leastAgreementAfterDrawing(-1), 0.8f) << "else nothing is tested";
	for (float least : {0.8f, 0.9f}) {
		EXPECT_GE(leastAgreementAfterDrawing(least), least);
		EXPECT_LT(leastAgreementAfterDrawing(least), least + 0.15f) << "as far as it may, nearly";
	}
}

/// The number of inverted faces after a move: a vertex beyond one side of its ring is drawn beyond
/// another side.
int invertedAfterDrawing(float minNormalAgreement, int& before)
{
	OnSurface     on(grid(8, 8));
	const int     v    = vertexNear(on, {0.5, 0.5, 0});
	const Vec3f   over = on.surface.frame.toWorking(Vec3d(0.5 + 1.15 / 8, 0.5 + 0.5 / 8, 0));
	SurfacePoint& at   = on.result.vertex[v].point;
	EXPECT_TRUE(walk(on.surface.mesh, at, over - at.position));
	on.m().position[v]    = at.position;
	before                = invertedFaceNum(on.surface, on.result, on.workers);
	Goal goal             = drawnAlong(on, v, {0, 1, 0});
	goal.limits.agreement = minNormalAgreement;
	search(on, goal);
	return invertedFaceNum(on.surface, on.result, on.workers);
}

TEST(LocalSearch, InvertsNoMoreFacesWhereSomeAreAlready)
{
	int before = 0;
	EXPECT_GT(invertedAfterDrawing(-1, before), before) << "without a limit";
	EXPECT_GT(before, 0);
	EXPECT_EQ(invertedAfterDrawing(0.6f, before), before);
}

/// Draws a vertex along x in steps, which are in edges. Returns how far the vertex came.
float drawAlongX(OnSurface& on, int v, float step, bool keepsContacts)
{
	const float start    = on.m().position[v].x;
	Goal        goal     = drawnAlong(on, v, {1, 0, 0});
	goal.stepLengths     = {step};
	goal.limits.contacts = keepsContacts;
	search(on, goal);
	return on.m().position[v].x - start;
}

/// Moves of the vertex at the top drag faces through the leaf.
float drawTop(OnSurface& on, bool keepsContacts)
{
	return drawAlongX(on, vertexNear(on, {0, 2, 1}), 0.05f, keepsContacts);
}

TEST(LocalSearch, MovesNoFaceThroughAnother)
{
	OnSurface   on(archOverLeaf());
	const float free = drawTop(on, false);
	ASSERT_FALSE(findTouchingPairs(on.m(), on.workers).empty()) << "else nothing is tested";

	OnSurface   guarded(archOverLeaf());
	const float way = drawTop(guarded, true);
	EXPECT_GT(way, 0) << "as far as it may";
	EXPECT_LT(way, free);
	EXPECT_TRUE(findTouchingPairs(guarded.m(), guarded.workers).empty());
}

/// With thousands of faces near a face, each patch looks for its own neighbours.
TEST(LocalSearch, MovesNoFaceThroughAnotherInACrowd)
{
	const TriangleMesh crowd = shifted(grid(50, 50, 0.01, 0.01), {0, 2, 1.1});
	OnSurface          on(joined(archOverLeaf(), crowd));
	const float        free = drawTop(on, false);
	ASSERT_FALSE(findTouchingPairs(on.m(), on.workers).empty()) << "else nothing is tested";

	OnSurface   guarded(joined(archOverLeaf(), crowd));
	const float way = drawTop(guarded, true);
	EXPECT_GT(way, 0) << "as far as it may";
	EXPECT_LT(way, free);
	EXPECT_TRUE(findTouchingPairs(guarded.m(), guarded.workers).empty());
}

/// A needle pierces the ring of a vertex, wherever the vertex lies in its ring. Draws the vertex
/// away from the needle; returns its way in edges.
float drawBesideANeedle(bool keepsContacts)
{
	TriangleMesh needle;
	needle.positions = {{0.46, 0.46, -0.03}, {0.47, 0.46, 0.03}, {0.46, 0.47, 0.03}};
	needle.triangles = {0, 1, 2};
	OnSurface on(joined(grid(8, 8), needle));
	EXPECT_FALSE(findTouchingPairs(on.m(), on.workers).empty());
	const float way = drawAlongX(on, vertexNear(on, {0.5, 0.5, 0}), 0.1f, keepsContacts);
	EXPECT_FALSE(findTouchingPairs(on.m(), on.workers).empty());
	return way / on.result.idealEdge;
}

TEST(LocalSearch, MovesFacesWithAContactThatStays)
{
	const float free = drawBesideANeedle(false);
	EXPECT_GT(free, 0.2f) << "else nothing is tested";
	EXPECT_GT(drawBesideANeedle(true), 0.5f * free);
}

/// The number of contacts after a search against contacts of wanted faces.
std::size_t contactsAfterSearch(OnSurface& on, const std::function<bool(int)>& isWanted)
{
	std::int64_t work = 100000000;
	LocalSearch  search(on.surface, on.boundary, nullptr, work, on.result, on.workers);
	search.run(facesInContact(search, isWanted));
	on.expectSound();
	on.expectOnSurface();
	return findTouchingPairs(on.m(), on.workers).size();
}

TEST(LocalSearch, MovesFacesInContactApart)
{
	OnSurface on(archOverLeaf());
	drawTop(on, false);
	const std::size_t before    = findTouchingPairs(on.m(), on.workers).size();
	const float       agreement = leastAgreement(on);
	ASSERT_GT(before, 0u);
	EXPECT_EQ(contactsAfterSearch(on, [](int) { return false; }), before) << "none is wanted";
	EXPECT_EQ(contactsAfterSearch(on, [](int) { return true; }), 0u);
	EXPECT_GT(on.minAngleDeg(), 5) << "not at any price";
	EXPECT_GE(leastAgreement(on), agreement);
}

TEST(PatchBackup, TakesFlipsSplitsAndCollapsesBack)
{
	Random      random(3);
	OnSurface   on(jitteredGrid(12, 0.2, random));
	EditScratch scratch;
	reserve(on.m(), on.m().vertexNum + 1, on.m().faceNum + 2);
	const std::vector<int> before  = tableOf(on.m());
	int                    changes = 0;
	for (int h = 0; h < on.m().halfEdgeNum(); ++h) {
		HalfEdgeMesh&    m = on.m();
		std::vector<int> ring{m.origin[h]};
		forEachNeighbour(m, m.origin[h], [&](int w) { ring.push_back(w); });
		const PatchBackup backup(m, ring, facesRound(m, ring));
		if (canCollapse(m, h, scratch)) {
			collapse(m, h);
			++changes;
		}
		else if (m.opposite[h] < 0)
			splitBorderEdge(m, h, m.vertexNum++);
		else if (canFlip(m, h) && h % 2 == 0)
			flip(m, h);
		else
			splitEdge(m, h, m.vertexNum++);
		ASSERT_NE(tableOf(m), before);
		backup.restore(m);
		ASSERT_EQ(tableOf(m), before) << "half-edge " << h;
	}
	EXPECT_GT(changes, 100);
}

TEST(CountTouchingPairs, AgreesWithTheSearchOverAllFaces)
{
	TriangleMesh sheets = joined(grid(12, 12), shifted(grid(12, 12), {0.013, 0.021, 0.05}));
	Workers      workers(2, nullptr);
	for (std::size_t v = 0; v < sheets.positions.size(); v += 7)
		sheets.positions[v].z += v < sheets.positions.size() / 2 ? 0.08 : -0.08;
	const HalfEdgeMesh     m     = halfEdgesOf(sheets);
	const std::vector<int> found = facesOf(findTouchingPairs(m, workers));
	ASSERT_FALSE(found.empty());
	std::vector<int> all(std::size_t(m.faceNum));
	std::iota(all.begin(), all.end(), 0);
	const FacesInSpace space(m, workers);
	for (int f = 0; f < m.faceNum; ++f) {
		const bool intersects = std::binary_search(found.begin(), found.end(), f);
		EXPECT_EQ(countTouchingPairs(m, {f}, all) > 0, intersects) << f;
		EXPECT_EQ(countTouchingPairs(m, {f}, space.near(boxOfFace(m, f))) > 0, intersects) << f;
	}
	int sum = 0;
	for (int f : found)
		sum += countTouchingPairs(m, {f}, all);
	EXPECT_EQ(2 * countTouchingPairs(m, all, {}), sum) << "each pair is counted once";
}

} // namespace gpr::test
