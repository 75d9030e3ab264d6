// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Promises of README.md and vcg_extras/docs/guarantees.md without a test elsewhere: a test for
// each, on meshes of every kind and with every preset. The checks share nothing with the engine.
// guarantees.md lists all promises with their tests.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/run_options.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <tuple>

namespace gpr::test {

namespace {

struct Shape {
	const char*                   name;
	std::function<TriangleMesh()> make;
	bool                          isSound = true;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

TriangleMesh damagedTorus()
{
	Random random(3);
	return damaged(torus(60, 30), 25, random);
}

TriangleMesh sheetWithHoles()
{
	Random random(1);
	return withHoles(jitteredGrid(40, 0.3, random), 3, random);
}

TriangleMesh soup()
{
	Random random(1);
	return soupOf(icosphere(4), 0, random);
}

std::vector<Shape> shapes()
{
	return {{"sphere", [] { return icosphere(4); }},
			{"torus", [] { return torus(60, 30); }},
			{"cube", [] { return cube(16); }},
			{"cylinder", [] { return openCylinder(50, 40, 0.5, 1.5); }},
			{"sheetWithHoles", sheetWithHoles},
			{"twoSheets", [] { return twoSheets(30, 0.02); }},
			{"moebiusStrip", [] { return moebiusStrip(120, 10); }, false},
			{"soup", soup, false},
			{"damagedTorus", damagedTorus, false}};
}

std::string nameOf(Preset preset)
{
	switch (preset) {
	case Preset::Default:
		return "default";
	case Preset::Fast:
		return "fast";
	default:
		return "paper";
	}
}

using Case = std::tuple<Shape, Preset>;

/// A mesh and a preset.
class Promise : public ::testing::TestWithParam<Case> {
protected:
	TriangleMesh input() const { return std::get<Shape>(GetParam()).make(); }
	bool         isSoundInput() const { return std::get<Shape>(GetParam()).isSound; }

	RemeshOptions options(std::int64_t vertexNum) const
	{
		RemeshOptions options;
		options.preset          = std::get<Preset>(GetParam());
		options.targetMode      = TargetMode::VertexNum;
		options.targetVertexNum = vertexNum;
		options.threads         = 2;
		return options;
	}
};

/// "Exactly the number of vertices asked for", but with the preset paper.
TEST_P(Promise, ExactlyTheNumberOfVerticesAskedFor)
{
	const TriangleMesh mesh = input();
	if (std::get<Preset>(GetParam()) == Preset::Paper) return;
	for (int vertexNum : {211, 600, 2500}) {
		const RemeshResult r = remesh(mesh.view(), options(vertexNum));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(factsOf(r.mesh).usedVertices, vertexNum);
		EXPECT_EQ(r.mesh.vertexNum(), std::size_t(vertexNum));
	}
}

/// "An oriented 2-manifold": no duplicate face, no degenerate face, no NaN.
TEST_P(Promise, AnOriented2Manifold)
{
	const TriangleMesh mesh = input();
	for (int vertexNum : {300, 1500}) {
		const RemeshResult r = remesh(mesh.view(), options(vertexNum));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(factsOf(r.mesh).complaints(), "");
		EXPECT_TRUE(isSoundSurface(r.mesh));
	}
}

/// "As many components, holes and handles as the repaired input has".
TEST_P(Promise, TheComponentsHolesAndHandlesOfTheRepairedInput)
{
	const TriangleMesh mesh = input();
	for (int vertexNum : {300, 1500}) {
		const RemeshResult r = remesh(mesh.view(), options(vertexNum));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const SurfaceFacts facts = factsOf(r.mesh);
		EXPECT_EQ(facts.components, r.report.cleanedInput.components);
		EXPECT_EQ(facts.boundaryLoops, r.report.cleanedInput.boundaryLoops);
		EXPECT_EQ(facts.euler(), r.report.cleanedInput.eulerCharacteristic);
		if (isSoundInput()) {
			EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
			EXPECT_FALSE(r.report.cleaned.changedInput());
		}
		else {
			EXPECT_TRUE(r.report.cleaned.changedInput());
		}
	}
}

/// "The same bytes for the same input, options and seed, with any number of threads".
TEST_P(Promise, TheSameBytesWithAnyNumberOfThreads)
{
	const TriangleMesh mesh    = input();
	RemeshOptions      wanted  = options(700);
	wanted.threads             = 1;
	const RemeshResult one     = remesh(mesh.view(), wanted);
	const std::size_t  byteNum = one.mesh.positions.size() * sizeof(Vec3d);
	ASSERT_EQ(one.status, Status::Ok) << one.message;
	for (int threads : {1, 2, 3, 8}) {
		wanted.threads       = threads;
		const RemeshResult r = remesh(mesh.view(), wanted);
		ASSERT_EQ(r.mesh.positions.size(), one.mesh.positions.size());
		EXPECT_EQ(r.mesh.triangles, one.mesh.triangles) << threads;
		EXPECT_EQ(std::memcmp(r.mesh.positions.data(), one.mesh.positions.data(), byteNum), 0)
			<< threads;
	}
}

/// Without the fit, every vertex lies on the surface of the input; the paper's umbrella steps stay
/// on the surface, too. Distances are measured to the nearest of all faces, with a bound for the
/// rounding of floats.
TEST_P(Promise, EveryVertexOnTheSurfaceWithoutTheFit)
{
	const TriangleMesh mesh   = input();
	RemeshOptions      wanted = options(250);
	if (wanted.preset != Preset::Paper) return;
	const RemeshResult r = remesh(mesh.view(), wanted);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	double farthest = 0;
	for (const Vec3d& p : r.mesh.positions)
		farthest = std::max(farthest, distanceToMesh(mesh, p));
	EXPECT_LT(farthest, 2e-6);
}

INSTANTIATE_TEST_SUITE_P(, Promise,
						 ::testing::Combine(::testing::ValuesIn(shapes()),
											::testing::Values(Preset::Default, Preset::Fast,
															  Preset::Paper)),
						 [](const auto& which) {
							 return std::string(std::get<Shape>(which.param).name) + "_" +
									nameOf(std::get<Preset>(which.param));
						 });

/// Largest distance of the segments' ends from other segments.
double farthestEnd(const std::vector<Vec3d>& ends, const std::vector<Vec3d>& segments)
{
	double farthest = 0;
	for (const Vec3d& end : ends) {
		double nearest = HUGE_VAL;
		for (std::size_t s = 0; s < segments.size(); s += 2)
			nearest = std::min(nearest, distanceToSegment(end, segments[s], segments[s + 1]));
		farthest = std::max(farthest, nearest);
	}
	return farthest;
}

/// Vertices of feature lines leave the line by at most 8 % of the wanted edge length. Border.* in
/// remesh_test.cpp tests borders.
TEST(PromiseOfSharpEdges, VerticesLeaveThemByAtMostEightPercentOfAnEdge)
{
	const TriangleMesh tin = closedCylinder(120, 60, 0.5, 1);
	for (int vertexNum : {300, 800}) {
		const RemeshResult r = remesh(tin.view(), countOptions(vertexNum));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const double edge  = std::sqrt(2 * r.report.input.area / (std::sqrt(3.0) * vertexNum));
		const auto   sharp = sharpSegments(r.mesh, 38);
		ASSERT_GT(sharp.size(), 40u) << "both rims are there";
		const double moved = farthestEnd(sharp, sharpSegments(tin, 40));
		EXPECT_LT(moved, 0.08 * edge);
		EXPECT_GT(moved, 0.001 * edge) << "the fit takes them to where the chords are nearest";
	}
}

struct Defect {
	const char*  name;
	TriangleMesh mesh;
	std::int64_t CleanCounts::*count;
	std::int64_t               wanted; ///< -1: any number above 0
	bool                       isCut = false;
};

/// Each mesh has a single kind of defect, a known number of times.
std::vector<Defect> defects()
{
	const TriangleMesh  ball = icosphere(5);
	std::vector<Defect> defects;
	TriangleMesh        mesh = ball;
	mesh.positions[100].y    = std::numeric_limits<double>::quiet_NaN();
	mesh.positions[5000].z   = HUGE_VAL;
	defects.push_back({"not finite", mesh, &CleanCounts::nonFiniteVertices, 2});
	mesh = ball;
	mesh.positions.insert(mesh.positions.end(), 7, Vec3d(1, 2, 3));
	defects.push_back({"in no face", mesh, &CleanCounts::unreferencedVertices, 7});
	Random random(1);
	mesh             = soupOf(ball, 0, random);
	const auto extra = std::int64_t(mesh.vertexNum() - ball.vertexNum());
	defects.push_back({"soup", mesh, &CleanCounts::weldedVertices, extra});
	mesh = ball;
	for (int v : {3, 8, 11})
		mesh.triangles.insert(mesh.triangles.end(), {v, v, v + 1});
	defects.push_back({"a vertex twice", mesh, &CleanCounts::repeatedIndexFaces, 3});
	mesh = ball;
	for (std::size_t f : {5u, 50u, 90u, 91u}) {
		const std::int32_t* t = &ball.triangles[3 * f];
		mesh.triangles.insert(mesh.triangles.end(), {t[0], t[1], t[2]});
	}
	defects.push_back({"a face twice", mesh, &CleanCounts::duplicateFaces, 4});
	mesh = ball;
	for (std::size_t f : {2u, 40u, 200u, 300u, 500u})
		std::swap(mesh.triangles[3 * f], mesh.triangles[3 * f + 1]);
	defects.push_back({"turned", mesh, &CleanCounts::reorientedFaces, 5});
	const auto besideBall = [&](const TriangleMesh& other) {
		return joined(ball, shifted(scaled(other, 0.05), {2, 0, 0}));
	};
	defects.push_back({"fins", besideBall(finsOnEdge(3)), &CleanCounts::nonManifoldEdges, 1, true});
	// Of so large faces the run takes parts; the parts of a face or an edge count once.
	defects.push_back({"large fins", finsOnEdge(3), &CleanCounts::nonManifoldEdges, 1, true});
	mesh = cube(1);
	std::swap(mesh.triangles[0], mesh.triangles[1]);
	defects.push_back({"a large face turned", mesh, &CleanCounts::reorientedFaces, 1});
	defects.push_back(
		{"fans", besideBall(fansSharingVertex(4)), &CleanCounts::nonManifoldVertices, 3});
	defects.push_back(
		{"one-sided", moebiusStrip(240, 20), &CleanCounts::nonOrientableCuts, -1, true});
	return defects;
}

/// Sum of all counts. Cuts turn faces and double vertices, which is counted too.
std::int64_t sumOf(const CleanCounts& c, bool hasCuts)
{
	const std::int64_t all = c.nonFiniteVertices + c.unreferencedVertices + c.weldedVertices +
							 c.repeatedIndexFaces + c.zeroAreaFaces + c.duplicateFaces +
							 c.reorientedFaces + c.nonManifoldEdges + c.nonManifoldVertices +
							 c.nonOrientableCuts + c.droppedComponents + c.contractedEdges;
	return hasCuts ? all - c.reorientedFaces - c.nonManifoldVertices : all;
}

/// "The report counts every repair and every cut".
TEST(PromiseOfRepair, EveryRepairAndEveryCutIsCounted)
{
	for (const Defect& defect : defects()) {
		SCOPED_TRACE(defect.name);
		const RemeshResult r = remesh(defect.mesh.view(), countOptions(400));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const std::int64_t found = r.report.cleaned.*defect.count;
		EXPECT_GT(found, 0);
		if (defect.wanted >= 0) {
			EXPECT_EQ(found, defect.wanted);
		}
		EXPECT_EQ(sumOf(r.report.cleaned, defect.isCut), found) << "nothing else was repaired";
		EXPECT_EQ(factsOf(r.mesh).complaints(), "");
	}
}

/// Inverted faces are counted, and a note names their number: a plate far thinner than its few
/// triangles are wide, bent so much that some faces are inverted.
TEST(PromiseOfInvertedFaces, TheyAreCountedAndANoteTellsOfThem)
{
	std::int64_t most = 0;
	for (int vertexNum : {12, 16, 20, 30, 60}) {
		TriangleMesh wavy = thinPlate(40, 0.004);
		for (Vec3d& p : wavy.positions)
			p.z += 0.15 * std::sin(12 * p.x) * std::sin(10 * p.y);
		const RemeshResult r = remesh(wavy.view(), countOptions(vertexNum));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const std::int64_t num      = r.report.audit.invertedFaces;
		const std::string  sentence = std::to_string(num) + " faces are inverted";
		const auto         tells    = [&](const std::string& note) {
            return note.find(num > 0 ? sentence : "inverted") != std::string::npos;
		};
		EXPECT_EQ(std::any_of(r.notes.begin(), r.notes.end(), tells), num > 0);
		most = std::max(most, num);
	}
	EXPECT_GT(most, 0) << "none of these meshes tests the note";
}

/// Plates of needles: the fit must not confuse the far side of a plate with the near side, whose
/// vertices are as many edges away.
TEST(PromiseOfTheFit, ItComesNearerToPlatesOfNeedles)
{
	for (double height : {0.1, 0.3}) {
		SCOPED_TRACE(height);
		const TriangleMesh plate = ringPlate(500, 0.4, height);
		double             with = 0, without = 0; // squared
		for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
			RemeshOptions options     = countOptions(600);
			options.check             = true;
			options.seed              = seed;
			const RemeshResult fitted = remesh(plate.view(), options);
			ASSERT_EQ(fitted.status, Status::Ok) << fitted.message;
			options.preset             = Preset::Fast;
			const RemeshResult onInput = remesh(plate.view(), options);
			ASSERT_EQ(onInput.status, Status::Ok) << onInput.message;
			const SurfaceDistance near = fitted.report.check.distance.larger();
			const SurfaceDistance far  = onInput.report.check.distance.larger();
			with += near.rms * near.rms;
			without += far.rms * far.rms;
			EXPECT_LE(near.max, 1.02 * far.max) << seed;
		}
		EXPECT_LT(std::sqrt(with), 0.82 * std::sqrt(without));
	}
}

double longestOverMeanEdge(const TriangleMesh& mesh)
{
	double longest = 0, sum = 0;
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
		const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
		const Vec3d       a    = mesh.positions[std::size_t(mesh.triangles[c])];
		const double      edge = length(mesh.positions[std::size_t(mesh.triangles[next])] - a);
		longest                = std::max(longest, edge);
		sum += edge;
	}
	return longest / (sum / double(mesh.triangles.size()));
}

/// A tube with rings of fine bumps: small triangles on the bumps cause splits of long edges of the
/// input.
TriangleMesh bumpyTube(int around, int along)
{
	TriangleMesh tube = openCylinder(around, along, 1, 4);
	for (Vec3d& p : tube.positions) {
		const double bump = std::exp(-40 * (p.z - 2) * (p.z - 2));
		const double grow = 1 + 0.08 * bump * std::cos(12 * std::atan2(p.y, p.x));
		p                 = {p.x * grow, p.y * grow, p.z};
	}
	return tube;
}

/// No triangle is several times as large as wanted, even if sizes change and edges are split.
TEST(PromiseOfSizes, NoEdgeIsSeveralTimesAsLongAsTheMean)
{
	for (double adapt : {0.1, 1.0}) {
		for (int vertexNum : {1500, 6000, 20000}) {
			SCOPED_TRACE(std::to_string(adapt) + " " + std::to_string(vertexNum));
			RemeshOptions options = countOptions(vertexNum);
			options.adapt         = adapt;
			const RemeshResult r  = remesh(bumpyTube(200, 120).view(), options);
			ASSERT_EQ(r.status, Status::Ok) << r.message;
			EXPECT_LT(longestOverMeanEdge(r.mesh), 3);
		}
	}
}

} // namespace

} // namespace gpr::test
