// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The placement of the paper through the facade of the engine: the result is a Poisson-disk
// sampling, and whole runs keep every promise.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/sampling/front_sampling.h>

#include <cstring>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

struct Shape {
	std::string  name;
	TriangleMesh mesh;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

std::vector<Shape> shapes()
{
	Random random(1);
	return {{"sphere", icosphere(4)},
			{"torus", torus(90, 46)},
			{"uvSphere", uvSphere(40, 70)},
			{"grid", grid(60, 60)},
			{"coarseGrid", grid(13, 13)},
			{"jitteredGrid", jitteredGrid(50, 0.3, random)},
			{"squareFrame", squareFrame(48, 20)},
			{"cylinder", openCylinder(60, 60, 0.5, 1.5)}};
}

RemeshOptions borderEdges(double percent, std::uint32_t seed)
{
	RemeshOptions options;
	options.preset        = Preset::Paper;
	options.targetPercent = percent;
	options.seed          = seed;
	options.threads       = 2;
	return options;
}

class BorderEdgeShapes : public ::testing::TestWithParam<Shape> {};

TEST_P(BorderEdgeShapes, SamplesAreAPoissonDiskSampling)
{
	constexpr double rounding = 1e-3;
	for (double percent : {3.0, 10.0, 40.0, 100.0, 200.0}) {
		// With fewer samples the chord does not tell the distance on the surface.
		if (percent / 100 * double(GetParam().mesh.vertexNum()) < 150) continue;
		for (std::uint32_t seed : testSeeds(2)) {
			SCOPED_TRACE(std::to_string(percent) + " %, seed " + std::to_string(seed));
			const SamplingResult s =
				samplePoissonDisks(GetParam().mesh.view(), borderEdges(percent, seed));
			ASSERT_EQ(s.status, Status::Ok) << s.message;
			ASSERT_TRUE(s.report.capsReached.empty());
			const double least = (1 - double(spacingSlack)) * s.diskRadius * (1 - rounding);
			EXPECT_EQ(pairsNearerThan(s.points, least), 0)
				<< "nearest pair at " << nearestPair(s.points).distance / s.diskRadius << " r";
			double farthest = 0;
			for (const Vec3d& p : GetParam().mesh.positions)
				farthest = std::max(farthest, distanceToNearest(s.points, p));
			EXPECT_LE(farthest, s.diskRadius * (1 + rounding));
		}
	}
}

TEST_P(BorderEdgeShapes, TheMeshKeepsEveryPromise)
{
	const TriangleMesh& mesh = GetParam().mesh;
	for (double percent : {10.0, 60.0}) {
		if (percent / 100 * double(mesh.vertexNum()) < 50) continue;
		const RemeshResult r = remesh(mesh.view(), borderEdges(percent, 1));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
		EXPECT_EQ(r.report.leftoverVertexNum, 0);
		EXPECT_GT(r.report.quality.aspectRatioMean, 0.8);
	}
}

TEST_P(BorderEdgeShapes, ThePaperAsWrittenLandsNearTheTarget)
{
	const RemeshResult r = remesh(GetParam().mesh.view(), borderEdges(20, 1));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_TRUE(hasSameTopology(r.mesh, GetParam().mesh));
	EXPECT_EQ(r.report.radiusConstant, 0.844);
	if (r.report.targetVertexNum < 300 || r.report.boundarySampleNum > 0) return;
	EXPECT_NEAR(double(r.mesh.vertexNum()) / double(r.report.targetVertexNum), 0.92, 0.1);
}

/// The report names the constant of eq. (1) with which the count would have met the target.
TEST(BorderEdge, TellsTheConstantThatWouldHaveHitTheTarget)
{
	RemeshOptions      options = borderEdges(20, 1);
	const RemeshResult r       = remesh(icosphere(5).view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	const double share = double(r.mesh.vertexNum()) / double(r.report.targetVertexNum);
	EXPECT_NEAR(r.report.radiusConstantForTarget, 0.844 * std::sqrt(share), 1e-9);
	ASSERT_EQ(r.notes.size(), 1u);
	EXPECT_NE(r.notes[0].find("in eq. (1), instead of 0.844"), std::string::npos) << r.notes[0];
	options.preset = Preset::Default;
	EXPECT_EQ(remesh(icosphere(5).view(), options).report.radiusConstantForTarget, 0);
}

/// Kept vertices do not depend on the constant.
TEST(BorderEdge, TellsTheCountBesideAKeptBorder)
{
	RemeshOptions options = borderEdges(20, 1);
	options.boundary      = BoundaryMode::Keep;
	const RemeshResult r  = remesh(openCylinder(60, 40, 0.5, 1).view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.report.radiusConstantForTarget, 0);
	ASSERT_FALSE(r.notes.empty());
	EXPECT_NE(r.notes[0].find("wanted vertices"), std::string::npos) << r.notes[0];
	EXPECT_EQ(r.notes[0].find("eq. (1)"), std::string::npos) << r.notes[0];
}

/// §4 of the paper: the input should have double the vertices of the output, else edges are split.
TEST(BorderEdge, SplitsEdgesWhereTheTargetIsAboveHalfOfTheInput)
{
	const TriangleMesh mesh = icosphere(4);
	for (double percent : {20.0, 60.0, 100.0, 200.0}) {
		const RemeshResult r = remesh(mesh.view(), borderEdges(percent, 1));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		// Each split of an inner edge makes a vertex.
		const double worked = double(mesh.vertexNum()) + double(r.report.cleaned.longEdgesSplit);
		EXPECT_GE(worked, 1.9 * double(r.report.targetVertexNum)) << percent << " %";
		EXPECT_EQ(r.report.cleaned.longEdgesSplit > 0, percent > 50) << percent << " %";
		EXPECT_GT(r.report.quality.aspectRatioMean, 0.82);
	}
}

/// Smoothing steps and flips, a choice of the user in the paper, both have an effect.
TEST(BorderEdge, SmoothingAndFlipsAreThoseAskedFor)
{
	const TriangleMesh mesh      = torus(90, 46);
	const auto         shapeWith = [&](int steps, int flips) {
        RemeshOptions options = borderEdges(20, 7);
        options.umbrellaSteps = steps;
        options.flipPasses    = flips;
        return remesh(mesh.view(), options).report.quality.aspectRatioMean;
	};
	const double bare = shapeWith(0, 0), flipped = shapeWith(0, 1000);
	const double one = shapeWith(1, 1000), five = shapeWith(5, 1000);
	EXPECT_NE(bare, flipped);
	EXPECT_LT(flipped + 0.02, one);
	EXPECT_LT(one, five);
}

INSTANTIATE_TEST_SUITE_P(, BorderEdgeShapes, ::testing::ValuesIn(shapes()),
						 [](const auto& shape) { return std::string(shape.param.name); });

TEST(BorderEdge, TheSameBytesForAnyNumberOfThreads)
{
	const TriangleMesh mesh    = torus(90, 46);
	RemeshOptions      options = borderEdges(20, 7);
	options.threads            = 1;
	const RemeshResult one     = remesh(mesh.view(), options);
	ASSERT_EQ(one.status, Status::Ok) << one.message;
	for (int threads = 2; threads <= 4; ++threads) {
		options.threads      = threads;
		const RemeshResult r = remesh(mesh.view(), options);
		EXPECT_TRUE(r.mesh.positions == one.mesh.positions) << threads << " threads";
		EXPECT_EQ(r.mesh.triangles, one.mesh.triangles);
	}
	options.seed = 8;
	EXPECT_FALSE(remesh(mesh.view(), options).mesh.positions == one.mesh.positions);
}

/// The other sheet is near through space and far on the surface: only the latter counts.
TEST(BorderEdge, DoesNotLeakFromSheetToSheet)
{
	const double       gap    = 0.02;
	const TriangleMesh sheets = twoSheets(40, gap);
	for (double percent : {2.0, 10.0, 50.0}) {
		const SamplingResult s = samplePoissonDisks(sheets.view(), borderEdges(percent, 1));
		ASSERT_EQ(s.status, Status::Ok);
		ASSERT_GT(s.diskRadius, gap) << "else nothing is tested";
		for (bool upper : {false, true}) {
			std::vector<Vec3d> own;
			for (const Vec3d& p : s.points) {
				if ((p.z > gap / 2) == upper) own.push_back(p);
			}
			for (const Vec3d& p : sheets.positions) {
				if ((p.z > gap / 2) == upper) {
					ASSERT_LE(distanceToNearest(own, p), s.diskRadius * 1.001);
				}
			}
		}
	}
}

/// A dust of closed components needs as many starts.
TEST(BorderEdge, ReachesEveryComponentOfADust)
{
	TriangleMesh dust;
	for (int i = 0; i < 300; ++i)
		dust = joined(dust, shifted(icosphere(1), Vec3d(3.0 * (i % 20), 3.0 * (i / 20), 0)));
	RemeshOptions      options = borderEdges(50, 1);
	const RemeshResult r       = remesh(dust.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(hasSameTopology(r.mesh, dust));
}

TEST(BorderEdge, KeepsTheTopologyOfRandomSurfaces)
{
	for (std::uint32_t seed : testSeeds(60)) {
		Random random(seed);
		SCOPED_TRACE(seed);
		const TriangleMesh mesh    = randomSurface(random);
		RemeshOptions      options = borderEdges(random.between(1, 150), seed);
		options.allowNearest       = true;
		const RemeshResult r       = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
	}
}

class DamagedBorderEdge : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(DamagedBorderEdge, CopesWithDamage)
{
	Random             random(GetParam());
	const TriangleMesh mesh    = damaged(randomSurface(random), 10, random);
	RemeshOptions      options = borderEdges(random.between(1, 150), GetParam());
	options.allowNearest       = true;
	const RemeshResult r       = remesh(mesh.view(), options);
	EXPECT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
}

INSTANTIATE_TEST_SUITE_P(Seeds, DamagedBorderEdge, ::testing::ValuesIn(testSeeds(20)));

} // namespace

} // namespace gpr::test
