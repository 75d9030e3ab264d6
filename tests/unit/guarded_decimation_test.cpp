// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Guarded edge collapses, and the relaxation afterwards: no new contacts.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/guard/cube_decimation.h>
#include <vcg_extras/core/guard/guarded_relaxation.h>
#include <vcg_extras/core/mesh/components.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/space_grid.h>
#include <vcg_extras/core/surface/local_nearest.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

double edgeFor(const TriangleMesh& mesh, std::int64_t vertexNum)
{
	double area = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const Vec3d a = mesh.positions[std::size_t(mesh.triangles[3 * f])];
		area += length(cross(mesh.positions[std::size_t(mesh.triangles[3 * f + 1])] - a,
							 mesh.positions[std::size_t(mesh.triangles[3 * f + 2])] - a)) /
				2;
	}
	return std::sqrt(2 * area / (std::sqrt(3.0) * double(vertexNum)));
}

GuardedSettings settingsFor(const TriangleMesh& mesh, std::int64_t vertexNum)
{
	GuardedSettings settings;
	settings.targetNum = vertexNum;
	settings.idealEdge = edgeFor(mesh, vertexNum);
	return settings;
}

/// A tube within a tube: walls far nearer to each other than the wanted edges are long.
TriangleMesh pipe()
{
	return joined(torus(120, 24, 1, 0.06), insideOut(torus(120, 24, 1, 0.05)));
}

struct Wanted {
	const char*  name;
	TriangleMesh mesh;
	int          vertexNum;
};

std::vector<Wanted> thinShapes()
{
	return {{"tube", torus(200, 12, 1, 0.02), 120},
			{"pipe", pipe(), 160},
			{"sheets", twoSheets(40, 0.001), 60},
			{"plate", thinPlate(40, 0.002), 80},
			{"needle", closedCylinder(16, 200, 0.01, 2), 60}};
}

/// The vertices that decimation, and a relaxation, leave.
std::vector<Vec3f> placesAfter(const TriangleMesh& mesh, std::int64_t vertexNum, int threads,
							   bool isRelaxed)
{
	Workers     workers(threads, nullptr);
	GuardedMesh g(halfEdgesOf(mesh), false);
	decimateGuarded(settingsFor(mesh, vertexNum), g, workers);
	if (isRelaxed) relaxGuarded(edgeFor(mesh, vertexNum), true, g, workers);
	return {g.mesh.position.begin(), g.mesh.position.begin() + g.mesh.vertexNum};
}

/// The largest distance of a vertex of the input from a mesh.
double farthestFrom(const TriangleMesh& mesh, const TriangleMesh& input)
{
	double farthest = 0;
	for (const Vec3d& p : input.positions)
		farthest = std::max(farthest, distanceToMesh(mesh, p));
	return farthest;
}

} // namespace

TEST(GuardedDecimation, ReachesTheCountWithoutContacts)
{
	Workers workers(2, nullptr);
	for (const Wanted& wanted : thinShapes()) {
		SCOPED_TRACE(wanted.name);
		GuardedMesh           g(halfEdgesOf(wanted.mesh), false);
		const GuardedSettings settings = settingsFor(wanted.mesh, wanted.vertexNum);
		ASSERT_TRUE(findTouchingPairs(g.mesh, workers).empty());
		EXPECT_TRUE(decimateGuarded(settings, g, workers));
		EXPECT_EQ(g.mesh.vertexNum, wanted.vertexNum);
		EXPECT_TRUE(findTouchingPairs(g.mesh, workers).empty());
		EXPECT_TRUE(isSoundSurface(meshOf(g.mesh)));
		EXPECT_TRUE(hasSameTopology(wanted.mesh, meshOf(g.mesh)));
		relaxGuarded(settings.idealEdge, true, g, workers);
		EXPECT_EQ(g.mesh.vertexNum, wanted.vertexNum);
		EXPECT_TRUE(findTouchingPairs(g.mesh, workers).empty());
		EXPECT_TRUE(hasSameTopology(wanted.mesh, meshOf(g.mesh)));
	}
}

/// Walls a thousandth of an edge apart stay apart without tests of the collapses in a plane.
TEST(GuardedDecimation, NeedsNoTestOfCollapsesInAPlane)
{
	Workers workers(2, nullptr);
	for (const Wanted& wanted : thinShapes()) {
		SCOPED_TRACE(wanted.name);
		GuardedMesh     g(halfEdgesOf(wanted.mesh), false);
		GuardedSettings settings = settingsFor(wanted.mesh, wanted.vertexNum);
		settings.untested        = 1e-5;
		EXPECT_TRUE(decimateGuarded(settings, g, workers));
		EXPECT_TRUE(findTouchingPairs(g.mesh, workers).empty());
	}
}

TEST(GuardedRelaxation, TakesNoVertexOfTheInputFartherOff)
{
	Workers workers(2, nullptr);
	for (const Wanted& wanted : thinShapes()) {
		SCOPED_TRACE(wanted.name);
		GuardedMesh           g(halfEdgesOf(wanted.mesh), false);
		const GuardedSettings settings = settingsFor(wanted.mesh, wanted.vertexNum);
		ASSERT_TRUE(decimateGuarded(settings, g, workers));
		const double before = farthestFrom(meshOf(g.mesh), wanted.mesh);
		relaxGuarded(settings.idealEdge, true, g, workers);
		EXPECT_LE(farthestFrom(meshOf(g.mesh), wanted.mesh),
				  std::max(before, 0.1 * settings.idealEdge) + 1e-6);
	}
}

TEST(GuardedDecimation, DoesNotDependOnThreads)
{
	const TriangleMesh       mesh  = pipe();
	const std::vector<Vec3f> first = placesAfter(mesh, 200, 1, true);
	EXPECT_EQ(placesAfter(mesh, 200, 4, true), first);
}

TEST(GuardedDecimation, StopsWhereNothingMoreIsAllowed)
{
	Workers            workers(1, nullptr);
	const TriangleMesh mesh = torus(40, 12);
	GuardedMesh        g(halfEdgesOf(mesh), false);
	EXPECT_FALSE(decimateGuarded(settingsFor(mesh, 3), g, workers));
	EXPECT_GE(g.mesh.vertexNum, 7) << "no torus has fewer";
	EXPECT_LT(g.mesh.vertexNum, 30);
	EXPECT_TRUE(findTouchingPairs(g.mesh, workers).empty());
	EXPECT_TRUE(hasSameTopology(mesh, meshOf(g.mesh)));
}

/// Degenerate faces, as in CAD files after a split of an edge in only one of its faces. Such faces
/// are long, and collapses of their edges cost more than all collapses on a ball of small
/// triangles.
TEST(GuardedDecimation, FacesWithoutAreaGoFirst)
{
	Workers      workers(2, nullptr);
	Random       random(3);
	TriangleMesh mesh = box(6, 5, 4, {6, 5, 4});
	for (int i = 0; i < 12; ++i)
		mesh = withFlatFace(mesh, std::size_t(random.below(int(mesh.triangles.size()))));
	mesh = joined(mesh, shifted(icosphere(3, 0.2), {-2, 0, 0}));
	GuardedMesh g(halfEdgesOf(mesh), true);
	ASSERT_GE(zeroAreaFaceNum(g.mesh, workers), 12);
	const int wanted = g.mesh.vertexNum - 12;
	EXPECT_TRUE(decimateGuarded(settingsFor(mesh, wanted), g, workers));
	EXPECT_EQ(g.mesh.vertexNum, wanted);
	EXPECT_EQ(zeroAreaFaceNum(g.mesh, workers), 0);
	EXPECT_TRUE(hasSameTopology(mesh, meshOf(g.mesh)));
}

TEST(GuardedDecimation, LeavesFixedVertices)
{
	Workers            workers(1, nullptr);
	const TriangleMesh mesh = icosphere(3);
	GuardedMesh        g(halfEdgesOf(mesh), false);
	std::vector<Vec3f> fixed;
	for (int v = 0; v < g.mesh.vertexNum; ++v) {
		if (g.mesh.position[v].z < 0.5f) continue;
		g.vertex[std::size_t(v)].isFixed = true;
		fixed.push_back(g.mesh.position[v]);
	}
	EXPECT_TRUE(decimateGuarded(settingsFor(mesh, int(fixed.size()) + 40), g, workers));
	relaxGuarded(edgeFor(mesh, 100), true, g, workers);
	std::vector<Vec3f> left;
	for (int v = 0; v < g.mesh.vertexNum; ++v) {
		if (g.vertex[std::size_t(v)].isFixed) left.push_back(g.mesh.position[v]);
	}
	EXPECT_EQ(left, fixed);
}

TEST(GuardedDecimation, KeepsTheBorderAndStaysOnTheSurface)
{
	Workers            workers(1, nullptr);
	const TriangleMesh mesh = gridWhere(24, 1, [](int i, int j) { return i < 8 || j < 12; });
	GuardedMesh        g(halfEdgesOf(mesh), false);
	ASSERT_TRUE(decimateGuarded(settingsFor(mesh, 60), g, workers));
	relaxGuarded(edgeFor(mesh, 60), true, g, workers);
	const TriangleMesh made = meshOf(g.mesh);
	EXPECT_TRUE(hasSameTopology(mesh, made));
	EXPECT_LT(rimDistance(made, mesh), 1e-5) << "straight borders stay, and so do their corners";
	EXPECT_LT(rimDistance(mesh, made), 1e-5);
}

TEST(GuardedDecimation, StaysOnTheVerticesWhereItMust)
{
	Workers            workers(1, nullptr);
	const TriangleMesh mesh = pipe();
	GuardedMesh        g(halfEdgesOf(mesh), false);
	GuardedSettings    settings = settingsFor(mesh, 200);
	settings.mayLeaveVertices   = false;
	const HalfEdgeMesh before   = halfEdgesOf(mesh);
	ASSERT_TRUE(decimateGuarded(settings, g, workers));
	relaxGuarded(settings.idealEdge, false, g, workers);
	EXPECT_TRUE(findTouchingPairs(g.mesh, workers).empty());
	for (int v = 0; v < g.mesh.vertexNum; ++v)
		EXPECT_TRUE(g.mesh.position[v] == before.position[g.vertex[std::size_t(v)].anchor]);
}

TEST(GuardedDecimation, AnchorsAreNear)
{
	Workers            workers(1, nullptr);
	const TriangleMesh mesh    = icosphere(4);
	const Surface      surface = surfaceOf(mesh, workers);
	GuardedMesh        g(copyOf(surface.mesh), false);
	const double       edge = edgeFor(mesh, 200) * surface.frame.scale;
	GuardedSettings    settings;
	settings.targetNum = 200;
	settings.idealEdge = edge;
	ASSERT_TRUE(decimateGuarded(settings, g, workers));
	for (int v = 0; v < g.mesh.vertexNum; ++v) {
		const Vec3f        p  = g.mesh.position[v];
		const SurfacePoint at = nearestByDescent(surface.mesh, g.vertex[std::size_t(v)].anchor, p);
		EXPECT_LT(length(at.position - p), 0.15 * edge);
		EXPECT_LT(length(surface.mesh.position[g.vertex[std::size_t(v)].anchor] - p), edge);
	}
}

TEST(GuardedDecimation, AddsNoContactsToThoseOfItsInput)
{
	Workers            workers(1, nullptr);
	const TriangleMesh mesh = joined(icosphere(4), shifted(icosphere(4), {1.2, 0.1, 0.05}));
	GuardedMesh        g(halfEdgesOf(mesh), true);
	const auto         before = findTouchingPairs(g.mesh, workers);
	ASSERT_FALSE(before.empty());
	EXPECT_TRUE(decimateGuarded(settingsFor(mesh, 400), g, workers));
	const auto after = findTouchingPairs(g.mesh, workers);
	EXPECT_FALSE(after.empty()) << "they cannot be taken apart";
	EXPECT_LT(after.size(), before.size());
	for (const FacePair& pair : after) {
		for (int f : {pair.first, pair.second})
			EXPECT_NEAR(g.mesh.faceCentre(f).x, 0.6, 0.35) << "where the spheres meet";
	}
}

TEST(Components, AreNumberedByTheirFirstFaces)
{
	Workers          workers(1, nullptr);
	const Components found =
		findComponents(halfEdgesOf(joined(icosphere(1), icosphere(0))), workers);
	EXPECT_EQ(found.num, 2);
	EXPECT_EQ(found.ofFace.front(), 0);
	EXPECT_EQ(std::count(found.ofFace.begin(), found.ofFace.end(), 1), 20);
}

// ---- in cubes

namespace {

/// Two walls nearer to each other than the edges are long, with enough vertices for cubes, open at
/// one end.
TriangleMesh largePipe()
{
	return joined(openCylinder(400, 160, 0.3, 1), insideOut(openCylinder(400, 160, 0.299, 1)));
}

std::size_t pointNum(const GuardedMesh& g)
{
	std::size_t num = 0;
	for (const GuardedVertex& v : g.vertex)
		num += v.points.size();
	return num;
}

double areaOf(const GuardedMesh& g)
{
	double area = 0;
	for (const GuardedVertex& v : g.vertex)
		area += double(v.area);
	return area;
}

} // namespace

TEST(CubeDecimation, LosesNoPointAndMakesNoContact)
{
	const TriangleMesh mesh = largePipe();
	Workers            workers(2, nullptr);
	GuardedMesh        g(halfEdgesOf(mesh), false);
	const std::size_t  points = pointNum(g);
	const double       area   = areaOf(g);
	ASSERT_TRUE(findTouchingPairs(g.mesh, workers).empty());
	GuardedSettings settings = settingsFor(mesh, 1000);
	EXPECT_TRUE(decimateGuarded(settings, g, workers));
	EXPECT_EQ(g.mesh.vertexNum, 1000);
	EXPECT_EQ(pointNum(g), points);
	EXPECT_NEAR(areaOf(g), area, 1e-4 * area);
	EXPECT_TRUE(findTouchingPairs(g.mesh, workers).empty());
	EXPECT_TRUE(isSoundSurface(meshOf(g.mesh)));
	EXPECT_TRUE(hasSameTopology(mesh, meshOf(g.mesh)));
}

TEST(CubeDecimation, KeepsFixedVertices)
{
	const TriangleMesh mesh = largePipe();
	Workers            workers(2, nullptr);
	GuardedMesh        g(halfEdgesOf(mesh), false);
	std::vector<Vec3f> kept;
	for (int v = 0; v < g.mesh.vertexNum; ++v) {
		if (v % 97 != 0) continue;
		g.vertex[v].isFixed = true;
		kept.push_back(g.mesh.position[v]);
	}
	EXPECT_TRUE(decimateGuarded(settingsFor(mesh, std::int64_t(kept.size()) + 500), g, workers));
	std::vector<Vec3f> left;
	for (int v = 0; v < g.mesh.vertexNum; ++v) {
		if (g.isFixed(v)) left.push_back(g.mesh.position[v]);
	}
	EXPECT_EQ(left, kept);
	EXPECT_TRUE(isSoundSurface(meshOf(g.mesh)));
}

/// The lowest point of the planes round a bump lies above the bump, here beyond a side of the cube.
TEST(CubeDecimation, KeepsMergedVerticesInTheirCube)
{
	TriangleMesh bumps = grid(150, 150, 2, 2);
	for (Vec3d& p : bumps.positions)
		p = {p.x - 1, p.y - 1, -1e-5 - 0.02 * (2 - std::cos(30 * p.x) - std::cos(30 * p.y))};
	const SpaceGrid space({{-1, -1, -1}, {1, 1, 1}}, 2);
	Workers         workers(2, nullptr);
	GuardedMesh     g(halfEdgesOf(bumps), false);
	GuardedSettings settings = settingsFor(bumps, 1000);
	settings.grid            = &space;
	settings.cube            = space.cubeOf({-0.5f, -0.5f, -0.5f});
	const int before         = g.mesh.vertexNum;
	collapseStrictly(settings, g, workers);
	g.compact(workers);
	EXPECT_LT(g.mesh.vertexNum, before);
	for (int v = 0; v < g.mesh.vertexNum; ++v)
		ASSERT_LT(g.mesh.position[v].z, 0);
}

TEST(CubeDecimation, DoesNotDependOnThreads)
{
	const TriangleMesh       mesh  = largePipe();
	const std::vector<Vec3f> first = placesAfter(mesh, 1000, 1, false);
	EXPECT_EQ(placesAfter(mesh, 1000, 4, false), first);
}

TEST(SpaceGrid, OverAnEmptyBoxHasOneCube)
{
	const SpaceGrid grid(Box<float>(), 64);
	EXPECT_EQ(grid.cubeNum(), 1);
	EXPECT_EQ(grid.cubeOf({1, 2, 3}), 0);
	EXPECT_EQ(grid.cubeOf(Box<float>().low), 0);
}

TEST(SpaceGrid, HasEachPointInOneCubeAndEachBoxInItsCubes)
{
	const SpaceGrid grid({{-1, -1, -1}, {3, 1, 0}}, 4);
	EXPECT_EQ(grid.cubeNum(), 4 * 2 * 1);
	EXPECT_EQ(grid.cubeNumOfEdge(), 4);
	EXPECT_EQ(grid.cubeNumOfSide(), 8);
	EXPECT_EQ(grid.cubeOf({-5, -5, -5}), 0);
	EXPECT_EQ(grid.cubeOf({9, 9, 9}), 7);
	EXPECT_NE(grid.cubeOf({0, -1, -1}), grid.cubeOf({-0.001f, -1, -1}));
	const Box<float> box({-0.5f, -0.5f, -0.5f}, {1.5f, 0.5f, -0.5f});
	std::vector<int> met;
	EXPECT_TRUE(grid.forEachCube(box, [&](int cube) {
		met.push_back(cube);
		return true;
	}));
	EXPECT_EQ(met, (std::vector<int>{0, 1, 2, 4, 5, 6}));
	EXPECT_EQ(grid.cubeNumOf(box), 6);
}

} // namespace gpr::test
