// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/mesh_zoo.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/measure.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

TEST(MeasureQuality, AnEquilateralTriangleIsPerfectInEveryMeasure)
{
	const TriangleMesh   t{{{0, 0, 0}, {2, 0, 0}, {1, std::sqrt(3.0), 0}}, {0, 1, 2}};
	const QualityFigures q = measureQuality(t.view());
	EXPECT_NEAR(q.radiusRatioMean, 1, 1e-12);
	EXPECT_NEAR(q.radiusRatioMin, 1, 1e-12);
	EXPECT_NEAR(q.aspectRatioMean, 1, 1e-12);
	EXPECT_NEAR(q.aspectRatioMin, 1, 1e-12);
	EXPECT_NEAR(q.minAngleDeg, 60, 1e-9);
	EXPECT_NEAR(q.meanMinAngleDeg, 60, 1e-9);
	EXPECT_NEAR(q.maxAngleDeg, 60, 1e-9);
	EXPECT_NEAR(q.meanEdgeLen, 2, 1e-12);
	EXPECT_EQ(q.below30Percent, 0);
}

/// 30°, 30°, 120° with equal sides 1: area √3/4, longest edge √3, inradius √3/2 / (2 + √3),
/// circumradius 1.
TEST(MeasureQuality, AnObtuseTriangleHasItsKnownMeasures)
{
	const double         w = std::sqrt(3.0);
	const TriangleMesh   t{{{0, 0, 0}, {w, 0, 0}, {w / 2, 0.5, 0}}, {0, 1, 2}};
	const QualityFigures q        = measureQuality(t.view());
	const double         inradius = w / 2 / (2 + w);
	EXPECT_NEAR(q.radiusRatioMean, 2 * inradius, 1e-12);
	EXPECT_NEAR(q.aspectRatioMean, 2 * inradius, 1e-12) << "2√3 r / √3";
	EXPECT_NEAR(q.minAngleDeg, 30, 1e-9);
	EXPECT_NEAR(q.maxAngleDeg, 120, 1e-9);
	EXPECT_NEAR(q.meanEdgeLen, (2 + w) / 3, 1e-12);
}

TEST(MeasureQuality, MeansAndExtremesAreOverAllFaces)
{
	// An equilateral triangle and a right triangle with equal legs: 2r/R = 2(√2 - 1).
	const TriangleMesh t{
		{{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
		{0, 1, 2, 3, 4, 5}};
	const QualityFigures q     = measureQuality(t.view());
	const double         right = 2 * (std::sqrt(2.0) - 1);
	EXPECT_NEAR(q.radiusRatioMin, right, 1e-12);
	EXPECT_NEAR(q.radiusRatioMean, (1 + right) / 2, 1e-12);
	EXPECT_NEAR(q.meanMinAngleDeg, 52.5, 1e-9);
	EXPECT_NEAR(q.minAngleDeg, 45, 1e-9);
	EXPECT_NEAR(q.maxAngleDeg, 90, 1e-9);
}

TEST(MeasureQuality, AFaceWithoutAreaIsTheWorstOfAll)
{
	const TriangleMesh   t{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {0, 1, 2, 0, 1, 3}};
	const QualityFigures q = measureQuality(t.view());
	EXPECT_EQ(q.radiusRatioMin, 0);
	EXPECT_EQ(q.aspectRatioMin, 0);
	EXPECT_EQ(q.minAngleDeg, 0);
	EXPECT_EQ(q.below30Percent, 50);
}

TEST(MeasureQuality, CountsVerticesWithSixFacesInsideOnly)
{
	EXPECT_NEAR(measureQuality(icosphere(3).view()).valence6Percent, 100.0 * (642 - 12) / 642,
				1e-9);
	// Diagonals alternate, so inner vertices of a grid have four or eight faces.
	EXPECT_EQ(measureQuality(grid(8, 8).view()).valence6Percent, 0);
}

TEST(MeasureQuality, DoesNotDependOnThreadsUnitOrPlace)
{
	const TriangleMesh   mesh = uvSphere(40, 80);
	const QualityFigures q    = measureQuality(mesh.view(), 1);
	EXPECT_EQ(measureQuality(mesh.view(), 4).radiusRatioMean, q.radiusRatioMean);
	for (double factor : {1e-9, 1e9}) {
		const QualityFigures s = measureQuality(scaled(mesh, factor).view(), 1);
		EXPECT_NEAR(s.radiusRatioMean, q.radiusRatioMean, 1e-9);
		EXPECT_NEAR(s.radiusRatioMin, q.radiusRatioMin, 1e-9);
		EXPECT_NEAR(s.meanEdgeLen, q.meanEdgeLen * factor, 1e-9 * factor);
	}
}

class MeasureZoo : public ::testing::TestWithParam<ZooMesh> {};

TEST_P(MeasureZoo, CountsWhatIsKnown)
{
	const ZooMesh&    zoo = GetParam();
	const MeshFigures m   = measureMesh(zoo.mesh.view());
	EXPECT_EQ(m.vertices, std::int64_t(zoo.mesh.vertexNum()));
	EXPECT_EQ(m.faces, std::int64_t(zoo.mesh.faceNum()));
	EXPECT_EQ(m.components, zoo.components);
	EXPECT_EQ(m.boundaryLoops, zoo.boundaryLoops);
	EXPECT_EQ(m.eulerCharacteristic, zoo.euler);
	EXPECT_NEAR(m.area, factsOf(zoo.mesh).area, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(, MeasureZoo, ::testing::ValuesIn(meshZoo()),
						 zooName<::testing::TestParamInfo<ZooMesh>>);

class MeasureRandom : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(MeasureRandom, AgreesWithTheAuditAndWithTheHalfEdges)
{
	Random             random(GetParam());
	Workers            workers(2, nullptr);
	const TriangleMesh mesh  = randomSurface(random);
	const SurfaceFacts facts = factsOf(mesh);
	const Surface      s     = surfaceOf(mesh, workers);
	for (const MeshFigures& m :
		 {measureMesh(mesh.view()), figuresOf(s.mesh, 1 / s.frame.scale, workers)}) {
		EXPECT_EQ(m.components, facts.components);
		EXPECT_EQ(m.boundaryLoops, facts.boundaryLoops);
		EXPECT_EQ(m.eulerCharacteristic, facts.euler());
		EXPECT_NEAR(m.area, facts.area, 1e-5 * facts.area);
	}
	EXPECT_NEAR(measureMesh(mesh.view()).diagonal,
				figuresOf(s.mesh, 1 / s.frame.scale, workers).diagonal, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Seeds, MeasureRandom, ::testing::ValuesIn(testSeeds(8)));

} // namespace

} // namespace gpr::test
