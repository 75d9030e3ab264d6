// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The stages that change edges of a result: flips, count, inverted faces, small angles. Each starts
// from a result with the vertices of the surface.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/optimization/delaunay_flips.h>
#include <vcg_extras/core/optimization/exact_count.h>
#include <vcg_extras/core/optimization/face_repair.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace gpr::test {

namespace {

class FlipToDelaunay : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(FlipToDelaunay, EndsDelaunayInThePlane)
{
	Random    random(GetParam());
	OnSurface on(jitteredGrid(24, 0.35, random));
	scramble(on.m(), random);
	const TriangleMesh before = meshOf(on.m());
	ASSERT_GT(edgesNotDelaunay(on.m()), 100);
	EXPECT_GT(flipToDelaunay(on.result, on.workers), 100);
	EXPECT_EQ(edgesNotDelaunay(on.m()), 0);
	on.expectSound();
	EXPECT_TRUE(hasSameTopology(meshOf(on.m()), before));
	EXPECT_NEAR(factsOf(meshOf(on.m())).area, factsOf(before).area, 1e-5) << "nothing overlaps";
	EXPECT_EQ(flipToDelaunay(on.result, on.workers), 0) << "and there is nothing left to do";
}

TEST_P(FlipToDelaunay, DoesNotDependOnThreads)
{
	Random random(GetParam());
	expectSameForAnyThreads(jitteredGrid(24, 0.35, random), [&](OnSurface& on, Workers& workers) {
		Random flips(GetParam());
		scramble(on.m(), flips);
		flipToDelaunay(on.result, workers);
	});
}

INSTANTIATE_TEST_SUITE_P(Seeds, FlipToDelaunay, ::testing::ValuesIn(testSeeds(4)));

ResultMesh twoTriangles(const std::vector<Vec3d>& corners)
{
	TriangleMesh quad;
	quad.positions = corners;
	quad.triangles = {0, 1, 2, 1, 0, 3};
	ResultMesh result;
	result.mesh = halfEdgesOf(quad);
	return result;
}

TEST(FlipToDelaunayKeeps, FacesFromTurningOver)
{
	Random  random(1);
	Workers workers(1, nullptr);
	int     flips = 0;
	for (int i = 0; i < 20000; ++i) {
		std::vector<Vec3d> corners;
		for (int k = 0; k < 4; ++k)
			corners.push_back({random.unit(), random.unit(), random.unit()});
		ResultMesh  result = twoTriangles(corners);
		const Vec3f before = result.mesh.faceCross(0) + result.mesh.faceCross(1);
		if (flipToDelaunay(result, workers) == 0) continue;
		++flips;
		for (int f : {0, 1})
			EXPECT_GT(dot(result.mesh.faceCross(f), before), 0) << i;
	}
	EXPECT_GT(flips, 500);
}

/// The fold of a bent sheet is an edge of the surface: a flip would cut the corner off.
TEST(FlipToDelaunayKeeps, ASharpFold)
{
	OnSurface on(bentSheet(12, 1.8));
	flipToDelaunay(on.result, on.workers);
	on.expectSound();
	const double area = 1;
	EXPECT_NEAR(factsOf(meshOf(on.m())).area / std::pow(on.surface.frame.scale, 2), area, 1e-5);
}

class ReachExactCount : public ::testing::TestWithParam<int> {};

TEST_P(ReachExactCount, HitsAnyNumberOnAnySurface)
{
	Random random(1);
	for (const TriangleMesh& mesh : {icosphere(3), torus(30, 20), jitteredGrid(24, 0.2, random),
									 openCylinder(24, 24, 0.5, 1.5)}) {
		OnSurface          on(mesh);
		const TriangleMesh before = meshOf(on.m());
		const int          target = int(before.vertexNum()) * GetParam() / 100;
		EXPECT_TRUE(reachExactCount(on.surface, on.boundary, {target}, on.result, on.workers));
		EXPECT_EQ(on.m().vertexNum, target);
		on.expectSound();
		on.expectOnSurface();
		EXPECT_TRUE(hasSameTopology(meshOf(on.m()), before));
	}
}

INSTANTIATE_TEST_SUITE_P(Percent, ReachExactCount,
						 ::testing::Values(30, 60, 95, 100, 103, 150, 250));

/// No vertex of the border may go, but border edges may be split.
void keepBorderVertices(OnSurface& on)
{
	for (ResultVertex& v : on.result.vertex)
		v.isPinned = v.curve >= 0;
}

/// An inner vertex changes the number of faces by two, so only the border can make the number odd.
TEST(ReachExactCount, GetsAnOddNumberOfFacesByTheBorder)
{
	OnSurface on(grid(20, 20));
	keepBorderVertices(on);
	const int wanted = on.m().faceNum - 99;
	EXPECT_TRUE(reachExactCount(on.surface, on.boundary, {0, wanted}, on.result, on.workers));
	EXPECT_EQ(on.m().faceNum, wanted);
	on.expectSound();
}

/// Moves a sheet so that its left side lies on the mirror plane: the sheet is half of a mesh then.
void putOnMirror(OnSurface& on)
{
	float left = 0;
	for (int v = 0; v < on.m().vertexNum; ++v)
		left = std::min(left, on.m().position[v].x);
	const auto shift = [&](Vec3f& p) { p.x -= left; };
	for (int v = 0; v < on.surface.mesh.vertexNum; ++v)
		shift(on.surface.mesh.position[v]);
	for (int v = 0; v < on.m().vertexNum; ++v) {
		shift(on.m().position[v]);
		shift(on.result.vertex[v].point.position);
	}
	for (Curve& curve : on.boundary.curves)
		std::for_each(curve.point.begin(), curve.point.end(), shift);
	on.surface.mesh.mirrorAxis = on.m().mirrorAxis = 0;
}

/// Of both halves.
int wholeVertexNum(const HalfEdgeMesh& m)
{
	return std::accumulate(&m.position[0], &m.position[0] + m.vertexNum, 0,
						   [&](int sum, const Vec3f& p) { return sum + m.multiplicity(p); });
}

/// A vertex off the mirror plane counts twice, so only a vertex on the plane can make the number of
/// the whole mesh odd or even.
TEST(ReachExactCount, GetsAnyNumberOfVerticesByTheMirrorPlane)
{
	OnSurface on(grid(20, 20));
	keepBorderVertices(on);
	putOnMirror(on);
	ASSERT_EQ(wholeVertexNum(on.m()), 2 * 20 * 21 + 21);
	const int wanted = wholeVertexNum(on.m()) - 101;
	EXPECT_TRUE(reachExactCount(on.surface, on.boundary, {wanted}, on.result, on.workers));
	EXPECT_EQ(wholeVertexNum(on.m()), wanted);
	on.expectSound();
}

TEST(ReachExactCountTells, WhenTheTopologyDoesNotAllowIt)
{
	OnSurface on(icosphere(2));
	EXPECT_FALSE(reachExactCount(on.surface, on.boundary, {3}, on.result, on.workers));
	EXPECT_GE(on.m().vertexNum, 4);
	EXPECT_LE(on.m().vertexNum, 6);
	on.expectSound();
}

TEST(ReachExactCountKeeps, TheCornersOfASquare)
{
	OnSurface on(grid(20, 20));
	for (ResultVertex& v : on.result.vertex) {
		const Vec3d p = on.surface.frame.toCaller(v.point.position);
		v.isCorner    = (p.x == 0 || p.x == 1) && (p.y == 0 || p.y == 1);
	}
	ASSERT_TRUE(reachExactCount(on.surface, on.boundary, {150}, on.result, on.workers));
	EXPECT_EQ(std::count_if(on.result.vertex.begin(), on.result.vertex.end(),
							[](const ResultVertex& v) { return v.isCorner; }),
			  4);
}

/// The number of passes is an option of the paper: none, some, and as many as needed.
TEST(FlipToDelaunay, StopsAfterSoManyPasses)
{
	const auto scrambled = [](OnSurface& on) {
		Random random(3);
		scramble(on.m(), random);
	};
	const TriangleMesh mesh = [] {
		Random random(2);
		return jitteredGrid(40, 0.3, random);
	}();
	OnSurface none(mesh), one(mesh), few(mesh), all(mesh);
	for (OnSurface* on : {&none, &one, &few, &all})
		scrambled(*on);
	EXPECT_EQ(flipToDelaunay(none.result, none.workers, 0), 0);
	const std::int64_t inOne = flipToDelaunay(one.result, one.workers, 1);
	const std::int64_t inFew = flipToDelaunay(few.result, few.workers, 50);
	EXPECT_GT(inOne, 50);
	EXPECT_GT(inFew, inOne);
	EXPECT_EQ(flipToDelaunay(few.result, few.workers), 0) << "50 passes are enough here";
	EXPECT_GT(flipToDelaunay(one.result, one.workers), 0) << "one is not";
	EXPECT_GT(flipToDelaunay(all.result, all.workers), inOne);
	one.expectSound();
	few.expectSound();
}

TEST(RaiseAnglesOnSurface, RaisesThemAndStaysThere)
{
	Random random(5);
	for (const TriangleMesh& mesh :
		 {jitteredGrid(30, 0.45, random), noisySphere(3, 0.02, random)}) {
		OnSurface    on(mesh);
		const double before  = on.minAngleDeg();
		const double below30 = measureQuality(meshOf(on.m()).view()).below30Percent;
		raiseAnglesOnSurface(on.surface, on.boundary, 32, on.result, on.workers);
		EXPECT_GE(on.minAngleDeg(), before);
		if (below30 > 0) {
			EXPECT_LT(measureQuality(meshOf(on.m()).view()).below30Percent, 0.5 * below30);
		}
		on.expectSound();
		on.expectOnSurface();
	}
}

int wrongFaces(OnSurface& on)
{
	const Buffer<Vec3f> normals = smoothNormals(on.surface, on.result, on.workers);
	int                 wrong   = 0;
	for (int f = 0; f < on.result.mesh.faceNum; ++f)
		wrong += normalAgreement(on.result.mesh, normals, f) < 0;
	return wrong;
}

/// Pulls inner vertices over the far side of their ring to fold faces back; returns the number of
/// such faces.
int fold(OnSurface& on, int every)
{
	const float far = 1.4f * on.result.idealEdge, aside = 0.3f * on.result.idealEdge;
	for (int v = 0; v < on.m().vertexNum; v += every) {
		if (on.m().isBorderVertex(v)) continue;
		walk(on.surface.mesh, on.result.vertex[v].point, {far, aside, 0});
		on.m().position[v] = on.result.vertex[v].point.position;
	}
	return wrongFaces(on);
}

TEST(RepairInvertedFaces, TurnsMostOfThem)
{
	for (bool mayCollapse : {false, true}) {
		OnSurface          on(grid(30, 30));
		const TriangleMesh before = meshOf(on.m());
		const int          wrong  = fold(on, 97);
		ASSERT_GT(wrong, 5);
		repairInvertedFaces(on.surface, on.boundary, mayCollapse, on.result, on.workers);
		EXPECT_LE(wrongFaces(on), mayCollapse ? wrong / 4 : wrong / 2) << "of " << wrong;
		EXPECT_TRUE(isSoundTable(on.m()));
		on.expectOnSurface();
		EXPECT_TRUE(hasSameTopology(meshOf(on.m()), before));
		if (!mayCollapse) {
			EXPECT_EQ(on.m().vertexNum, int(before.vertexNum()));
		}
	}
}

TEST(RepairInvertedFaces, LeavesAGoodMeshAlone)
{
	OnSurface          on(icosphere(3));
	const TriangleMesh before = meshOf(on.m());
	repairInvertedFaces(on.surface, on.boundary, true, on.result, on.workers);
	EXPECT_EQ(meshOf(on.m()).triangles, before.triangles);
	EXPECT_TRUE(meshOf(on.m()).positions == before.positions);
}

TEST(RepairInvertedFaces, DoesNotDependOnThreads)
{
	expectSameForAnyThreads(grid(30, 30), [](OnSurface& on, Workers& workers) {
		fold(on, 97);
		repairInvertedFaces(on.surface, on.boundary, true, on.result, workers);
	});
}

TEST(TriangleMeasures, AreThoseOfKnownTriangles)
{
	const Vec3f a(0, 0, 0), b(1, 0, 0), top(0.5f, float(std::sqrt(0.75)), 0);
	EXPECT_NEAR(double(triangleShape(a, b, top)), 1, 1e-6);
	EXPECT_NEAR(double(smallestAngle(a, b, top)), 3.14159265 / 3, 1e-6);
	EXPECT_NEAR(double(smallestAngle(a, b, {0, 1, 0})), 3.14159265 / 4, 1e-6);
	EXPECT_EQ(triangleShape(a, b, {2, 0, 0}), 0);
	EXPECT_EQ(smallestAngle(a, b, {2, 0, 0}), 0);
}

} // namespace

} // namespace gpr::test
