// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/output/thorough_check.h>
#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

class ThoroughCheck : public ::testing::Test {
protected:
	Workers workers{2, nullptr};

	CheckFigures checked(const TriangleMesh& input, const TriangleMesh& result)
	{
		const Surface surface = surfaceOf(input, workers);
		ResultMesh    made;
		made.mesh = halfEdgesOf(result);
		return checkThoroughly(surface, made, ComparedSurfaces(surface, made, workers), workers);
	}
};

TEST_F(ThoroughCheck, FindsNothingOnASphereAndItself)
{
	const CheckFigures c = checked(icosphere(3, 0.5), icosphere(3, 0.5));
	EXPECT_TRUE(c.done);
	EXPECT_EQ(c.intersectingFaces, 0);
	EXPECT_LT(c.vertexDistance, 1e-6);
	EXPECT_EQ(describeFailure(c, 0), "");
}

TEST_F(ThoroughCheck, CatchesFacesThatCrossOthers)
{
	const TriangleMesh apart = joined(icosphere(2, 0.2), shifted(icosphere(2, 0.2), {0.5, 0, 0}));
	const TriangleMesh crossed =
		joined(icosphere(2, 0.2), shifted(icosphere(2, 0.2), {0.2, 0.03, 0.01}));
	const CheckFigures c = checked(apart, crossed);
	EXPECT_GT(c.intersectingFaces, 10);
	EXPECT_EQ(c.inputIntersectingFaces, 0);
	EXPECT_NE(describeFailure(c, 1).find("self-intersecting"), std::string::npos);
	const CheckFigures both = checked(crossed, crossed);
	EXPECT_EQ(both.inputIntersectingFaces, both.intersectingFaces);
	EXPECT_EQ(describeFailure(both, 0), "") << "no more than the input";
}

TEST_F(ThoroughCheck, CatchesAVertexThatLeftTheSurface)
{
	TriangleMesh moved   = icosphere(3, 0.5);
	moved.positions[77]  = moved.positions[77] * 1.05;
	const CheckFigures c = checked(icosphere(3, 0.5), moved);
	EXPECT_NEAR(c.vertexDistance, 0.025, 1e-4);
	EXPECT_GE(c.largestDistance, c.vertexDistance - 1e-6);
	EXPECT_NE(describeFailure(c, 0.02), "");
	EXPECT_EQ(describeFailure(c, 0.026), "");
}

TEST_F(ThoroughCheck, CatchesAPartOfTheInputThatIsNotCovered)
{
	TriangleMesh part = grid(10, 10);
	part.triangles.resize(part.triangles.size() / 2);
	EXPECT_NEAR(checked(grid(10, 10), withoutUnused(part)).largestDistance, 0.5, 0.01);
}

TEST(CheckOption, TellsDistancesInTheCallersUnit)
{
	RemeshOptions options;
	options.check        = true;
	options.threads      = 2;
	const RemeshResult r = remesh(icosphere(4, 1000).view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(r.report.check.done);
	EXPECT_EQ(r.report.check.intersectingFaces, 0);
	const MutualDistance& d = r.report.check.distance;
	EXPECT_EQ(d.larger().max, r.report.check.largestDistance);
	for (const SurfaceDistance& way : {d.toInput, d.fromInput}) {
		EXPECT_GT(way.rms, 0.1);
		EXPECT_GT(way.p999, way.rms);
		EXPECT_LE(way.p999, way.max);
	}
	ASSERT_TRUE(r.report.isDistanceProven);
	const DistanceBounds proven = r.report.provenDistance.hausdorff();
	EXPECT_LE(proven.lower, r.report.check.largestDistance);
	EXPECT_GE(proven.upper, r.report.check.largestDistance);
	EXPECT_LE(proven.upper, 1.01 * proven.lower + 1e-5 * r.report.input.diagonal);
	EXPECT_GT(r.report.check.largestDistance, 1);
	EXPECT_LT(r.report.check.largestDistance, 30);
	EXPECT_NEAR(r.report.check.vertexDistance, r.report.largestFitDistance, 0.5);
	EXPECT_FALSE(remesh(icosphere(2).view(), RemeshOptions()).report.check.done);
}

/// Two sides of a plate far thinner than its few triangles are wide.
TEST(CheckOption, WithholdsWhatCrossesItself)
{
	TriangleMesh wavy = thinPlate(40, 0.004);
	for (Vec3d& p : wavy.positions)
		p.z += 0.05 * std::sin(12 * p.x) * std::sin(10 * p.y);
	RemeshOptions options;
	options.threads          = 2;
	options.targetMode       = TargetMode::VertexNum;
	options.targetVertexNum  = 60;
	options.preset           = Preset::Fast; // a fit would take the faces apart
	options.guard            = false;        // so would this
	const RemeshResult plain = remesh(wavy.view(), options);
	ASSERT_EQ(plain.status, Status::Ok) << plain.message;
	options.check        = true;
	const RemeshResult r = remesh(wavy.view(), options);
	EXPECT_EQ(r.status, Status::PromiseBroken);
	EXPECT_EQ(r.mesh.vertexNum(), 0u);
	EXPECT_GT(r.report.check.intersectingFaces, 0);
}

/// The sides of a cut meet in the input; they may cross where the result has fewer vertices.
TEST(CheckOption, MakesNoPromiseWhereAOneSidedSurfaceIsCut)
{
	RemeshOptions options;
	options.check         = true;
	options.threads       = 2;
	options.targetPercent = 10;
	bool doCross          = false;
	for (std::uint32_t seed = 1; seed <= 4; ++seed) {
		options.seed         = seed;
		const RemeshResult r = remesh(moebiusStrip(60, 8).view(), options);
		EXPECT_EQ(r.status, Status::Ok) << "seed " << seed << ": " << r.message;
		doCross = doCross || r.report.check.intersectingFaces > 0;
		if (r.report.check.intersectingFaces > 0) {
			EXPECT_GT(r.report.check.inputIntersectingFaces, 0);
		}
	}
	EXPECT_TRUE(doCross) << "nothing was tested";
}

} // namespace

} // namespace gpr::test
