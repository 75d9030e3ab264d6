// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// New vertices at places where a result is too far from the surface.

#include <tests/support/laid.h>
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/base/angle.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/optimization/goal_refinement.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr double height = 0.12;
const Vec3d      tip(0.37, 0.61, 0);

/// A plane with a tent narrower than the cells of the coarse mesh.
TriangleMesh tent(int cells)
{
	TriangleMesh mesh = grid(cells, cells);
	for (Vec3d& p : mesh.positions)
		p.z = std::max(0.0, height - 1.5 * length(p - tip));
	return mesh;
}

/// A plane with nine such tents.
TriangleMesh tents(int cells)
{
	TriangleMesh mesh = grid(cells, cells);
	for (Vec3d& p : mesh.positions) {
		for (double x : {0.21, 0.52, 0.83}) {
			for (double y : {0.18, 0.49, 0.79})
				p.z = std::max(p.z, height / 2 - 1.5 * length(Vec3d(p.x - x, p.y - y, 0)));
		}
	}
	return mesh;
}

/// Points of both meshes farther from the other mesh than a limit, working units.
std::vector<FarPoint> pointsBeyond(Laid& on, double limit)
{
	const MeasuredSurface surface(viewOf(on.surface.mesh), on.workers);
	const MeasuredSurface result(viewOf(on.result.mesh), surface, on.workers);
	std::vector<FarPoint> points;
	for (const FarPlace& p : placesBeyond(surface, result, limit, on.workers))
		points.push_back({Vec3f(p.position), float(p.distance), true});
	for (const FarPlace& p : placesBeyond(result, surface, limit, on.workers))
		points.push_back({Vec3f(p.position), float(p.distance), false});
	return points;
}

/// The vertex in the middle of an edge of the unit cube, or -1.
int middleOfACrease(const Laid& on)
{
	for (int v = 0; v < on.result.mesh.vertexNum; ++v) {
		if (length(on.at(v) - Vec3d(0.5, 0, 0)) < 1e-4) return v;
	}
	return -1;
}

/// More than any test here may need.
constexpr int many = 1000;

template <class On>
int refineAt(On& on, const std::vector<FarPoint>& points, double limit, int mostNew = many)
{
	return gpr::refineAt(on.surface, on.boundary, points, float(limit), mostNew, on.result,
						 on.workers);
}

} // namespace

TEST(RefineAt, BringsTheResultNearWhereItWasFar)
{
	Laid         on(tent(100), grid(12, 12));
	const double limit  = 0.08 * height * on.surface.frame.scale;
	const int    before = on.result.mesh.vertexNum;
	ASSERT_FALSE(pointsBeyond(on, limit).empty());
	int added = 0;
	for (int round = 0; round < 12; ++round) {
		const std::vector<FarPoint> points = pointsBeyond(on, limit);
		if (points.empty()) break;
		added += refineAt(on, points, limit);
	}
	EXPECT_TRUE(pointsBeyond(on, limit).empty());
	EXPECT_EQ(on.result.mesh.vertexNum, before + added);
	EXPECT_EQ(on.result.splitNum, added);
	EXPECT_LT(added, before) << "only near the tent";
	EXPECT_TRUE(findTouchingPairs(on.result.mesh, on.workers).empty());
	EXPECT_TRUE(isSoundTable(on.result.mesh));
}

/// Later rounds look only at points found before and at faces that changed.
TEST(RefineToGoal, LeavesNoPointBeyondTheGoal)
{
	Laid         on(tents(120), grid(45, 45));
	const double goal = 0.04 * height * on.surface.frame.scale;
	ASSERT_GT(pointsBeyond(on, goal).size(), 9u);
	EXPECT_EQ(refineToGoal(on.surface, on.boundary, goal, on.result, on.workers).outcome,
			  GoalOutcome::Kept);
	EXPECT_TRUE(pointsBeyond(on, goal).empty());
	EXPECT_GT(on.result.splitNum, 9);
	EXPECT_TRUE(isSoundTable(on.result.mesh));
}

TEST(RefineToGoal, AddsNothingIfAllTrianglesAreTooLarge)
{
	Laid         on(tents(120), grid(4, 4));
	const int    before = on.result.mesh.vertexNum;
	const double goal   = 0.01 * height * on.surface.frame.scale;
	EXPECT_EQ(refineToGoal(on.surface, on.boundary, goal, on.result, on.workers).outcome,
			  GoalOutcome::OutOfReach);
	EXPECT_EQ(on.result.mesh.vertexNum, before);
}

/// A sheet above the result: hundreds of points stay far, because no vertex of the result may come
/// to them. Only the points of the tents are brought near, in few rounds.
TEST(RefineToGoal, EndsWhereNoNewVertexHelps)
{
	TriangleMesh sheet = grid(40, 40);
	for (Vec3d& p : sheet.positions)
		p.z = 1;
	Laid         on(joined(tents(120), sheet), grid(45, 45));
	const int    before = on.result.mesh.vertexNum;
	const double goal   = 0.04 * height * on.surface.frame.scale;
	EXPECT_EQ(refineToGoal(on.surface, on.boundary, goal, on.result, on.workers).outcome,
			  GoalOutcome::OutOfReach);
	EXPECT_LT(on.result.mesh.vertexNum, 2 * before);
}

TEST(RefineAt, PutsAVertexAtAFarPoint)
{
	Laid         on(tent(100), grid(12, 12));
	const double limit = 0.2 * height * on.surface.frame.scale;
	FarPoint     farthest{};
	for (const FarPoint& p : pointsBeyond(on, limit)) {
		if (p.isOfSurface && p.distance > farthest.distance) farthest = p;
	}
	ASSERT_GT(farthest.distance, 0);
	refineAt(on, {farthest}, limit);
	float nearest = HUGE_VALF;
	for (int v = 0; v < on.result.mesh.vertexNum; ++v)
		nearest = std::min(nearest, length(on.result.mesh.position[v] - farthest.position));
	EXPECT_LT(nearest, 0.05f * farthest.distance);
}

TEST(RefineAt, LeavesAllElseAsItWas)
{
	Laid             on(tent(100), grid(12, 12));
	const ResultMesh before = copyResult(on.result, on.workers);
	const double     limit  = 0.2 * height * on.surface.frame.scale;
	const auto       points = pointsBeyond(on, limit);
	const float      near   = float(0.4 * on.surface.frame.scale);
	const Vec3f      middle = on.surface.frame.toWorking(tip);
	refineAt(on, points, limit);
	int same = 0;
	for (int v = 0; v < before.mesh.vertexNum; ++v) {
		if (length(before.mesh.position[v] - middle) < near) continue;
		EXPECT_EQ(on.result.mesh.position[v], before.mesh.position[v]) << v;
		++same;
	}
	EXPECT_GT(same, before.mesh.vertexNum / 3);
}

TEST(RefineAt, ChangesNothingWhereItWouldNeedTooManyVertices)
{
	Laid         on(tent(100), grid(12, 12));
	const double limit  = 0.08 * height * on.surface.frame.scale;
	const int    before = on.result.mesh.vertexNum;
	EXPECT_EQ(refineAt(on, pointsBeyond(on, limit), limit, 1), 0);
	EXPECT_EQ(on.result.mesh.vertexNum, before);
}

TEST(RefineAt, EndsWhenTheBudgetOfContactTestsIsSpent)
{
	const auto addedWith = [](std::int64_t work) {
		Laid         on(tent(100), grid(12, 12));
		const double limit = 0.08 * height * on.surface.frame.scale;
		return gpr::refineAt(on.surface, on.boundary, pointsBeyond(on, limit), float(limit), many,
							 on.result, on.workers, work);
	};
	const int all = addedWith(workOf(Driver::Refinement));
	EXPECT_GT(all, 1);
	EXPECT_EQ(addedWith(0), 0);
	EXPECT_LT(addedWith(1000), all);
}

/// A point beside the border splits a border edge, or the border would stay coarse.
TEST(RefineAt, SplitsTheBorderBesideAPoint)
{
	OnSurface                   on(grid(8, 8));
	const std::vector<FarPoint> points = {
		{on.surface.frame.toWorking(Vec3d(0.36, 0.001, 0)), 0.1f, false}};
	ASSERT_EQ(refineAt(on, points, 1), 1);
	EXPECT_TRUE(on.result.mesh.isBorderVertex(on.result.mesh.vertexNum - 1));
}

/// Splits beside a point that stays far would only crowd vertices.
TEST(RefineAt, MakesNoVertexThatLeavesItsPointFar)
{
	OnSurface                   on(grid(8, 8));
	const auto                  before = meshOf(on.result.mesh).positions;
	const Vec3d                 above(0.36, 0.44, 0.3); // no point of the surface is there
	const std::vector<FarPoint> points = {
		{on.surface.frame.toWorking(above), float(0.3 * on.surface.frame.scale), true}};
	EXPECT_EQ(refineAt(on, points, 1), 0);
	EXPECT_TRUE(meshOf(on.result.mesh).positions == before);
}

TEST(FarPoints, AreDrawnNearWithoutNewVertices)
{
	Laid         on(icosphere(6), icosphere(3));
	const double limit  = 0.6 * on.farthest() * on.meanEdge();
	const auto   before = pointsBeyond(on, limit);
	ASSERT_GT(before.size(), 100u);
	const int            vertexNum = on.result.mesh.vertexNum;
	const ClosestFaceMap map(on.surface, on.result, on.workers);
	const auto           left =
		drawToPoints(before, on.surface, map, 20 * radians, float(limit), on.result, on.workers);
	EXPECT_LT(left.size(), before.size() / 4);
	EXPECT_LT(pointsBeyond(on, limit).size(), before.size() / 4);
	EXPECT_EQ(on.result.mesh.vertexNum, vertexNum);
	EXPECT_TRUE(findTouchingPairs(on.result.mesh, on.workers).empty());
}

/// No vertex of the input lies near the far points: the crease edges of the input are long.
TEST(FarPoints, MayLieInTheMiddleOfACreaseEdge)
{
	Laid      on(cube(1), cube(4));
	const int vertex = middleOfACrease(on);
	ASSERT_GE(vertex, 0);
	Vec3f&      at     = on.result.mesh.position[vertex];
	const Vec3f inside = on.surface.frame.toWorking(Vec3d(0.5, 0.5, 0.5)) - at;
	at += inside * (0.1f * on.meanEdge() / length(inside));
	const double limit  = 0.02 * on.meanEdge();
	const auto   points = pointsBeyond(on, limit);
	ASSERT_FALSE(points.empty());
	const ClosestFaceMap map(on.surface, on.result, on.workers);
	EXPECT_TRUE(
		drawToPoints(points, on.surface, map, 20 * radians, float(limit), on.result, on.workers)
			.empty());
	EXPECT_TRUE(pointsBeyond(on, limit).empty());
}

TEST(RefineAt, DoesNotDependOnThreads)
{
	const auto refined = [](int threads) {
		Laid         on(tent(100), grid(12, 12), threads);
		const double limit = 0.08 * height * on.surface.frame.scale;
		for (int round = 0; round < 3; ++round)
			refineAt(on, pointsBeyond(on, limit), limit);
		return meshOf(on.result.mesh);
	};
	const TriangleMesh one = refined(1), four = refined(4);
	EXPECT_EQ(one.positions, four.positions);
	EXPECT_EQ(one.triangles, four.triangles);
}

} // namespace gpr::test
