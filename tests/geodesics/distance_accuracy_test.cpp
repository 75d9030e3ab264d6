// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The distances of the sampling, up to twice the disk radius, compared with exact geodesics.

#include "distance_accuracy.h"
#include "distance_cases.h"
#include "exact_distances.h"

#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <vcg_extras/io/mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace gpr::test {

std::ostream& operator<<(std::ostream& out, const DistanceCase& c)
{
	return out << c.name;
}

namespace {

constexpr int sourceNum = 25;

void expectWithin(const DistanceCase& c, const MeshView& mesh)
{
	const Ground ground(mesh, c.percent);
	for (Metric metric : {Metric::Default, Metric::BorderEdge}) {
		for (double reach : {1.0, 2.0}) {
			SCOPED_TRACE(std::string(metric == Metric::Default ? "default" : "border edges") +
						 ", reach " + std::to_string(reach));
			const Accuracy a = measureAccuracy(ground, metric, reach, sourceNum, 2);
			EXPECT_GT(a.vertexNum, 15 * sourceNum) << "else little was tested";
			EXPECT_EQ(a.unreachedNum, 0);
			EXPECT_LE(a.mean, c.maxMean);
			EXPECT_LE(a.largestOver, c.maxLargest);
			EXPECT_GE(a.largestUnder, -c.maxLargest);
		}
	}
}

class MadeSurface : public ::testing::TestWithParam<DistanceCase> {};

TEST_P(MadeSurface, DistancesAreThoseOfExactGeodesics)
{
	expectWithin(GetParam(), GetParam().mesh.view());
}

INSTANTIATE_TEST_SUITE_P(, MadeSurface, ::testing::ValuesIn(madeDistanceCases()),
						 [](const auto& c) { return c.param.name; });

class ModelSurface : public ::testing::TestWithParam<DistanceCase> {};

TEST_P(ModelSurface, DistancesAreThoseOfExactGeodesics)
{
	const char* folder = std::getenv("GPR_MODELS_DIR");
	if (folder == nullptr) GTEST_SKIP() << "GPR_MODELS_DIR is not set";
	const std::string path = std::string(folder) + "/" + GetParam().name + ".ply";
	if (!std::ifstream(path)) GTEST_SKIP() << GetParam().name << " is not there";
	expectWithin(GetParam(), app::readMesh(path).view());
}

INSTANTIATE_TEST_SUITE_P(, ModelSurface, ::testing::ValuesIn(modelDistanceCases()),
						 [](const auto& c) { return c.param.name; });

/// The errors fall with the edges of the grid. The largest errors are next to the source.
TEST(UnderAStretch, DistancesAreThoseOfTheHyperbolicPlane)
{
	for (int cellNum : {20, 40, 80}) {
		for (double radius : {0.2, 0.4}) {
			SCOPED_TRACE(std::to_string(cellNum) + " cells, radius " + std::to_string(radius));
			const Accuracy a       = measureUnderStretch(cellNum, radius, sourceNum, 2);
			const double   maxMean = 0.7 / cellNum, maxLargest = 16.0 / cellNum;
			EXPECT_GT(a.vertexNum, 10 * sourceNum) << "else little was tested";
			EXPECT_EQ(a.unreachedNum, 0);
			EXPECT_LE(a.mean, maxMean);
			EXPECT_LE(a.largestOver, maxLargest);
			EXPECT_GE(a.largestUnder, -maxLargest);
		}
	}
}

/// The judge itself: right angles over an edge of a cube, and straight on in the plane.
TEST(ExactDistances, AreThoseOfTheUnfoldedCube)
{
	Workers             workers(1, nullptr);
	const Surface       surface = surfaceOf(cube(8), workers);
	const HalfEdgeMesh& m       = surface.mesh;
	const auto          place   = [&](int v) { return surface.frame.toCaller(m.position[v]); };
	int                 from    = 0;
	for (int v = 0; v < m.vertexNum; ++v) {
		if (length(place(v) - Vec3d(0.5, 0.5, 1)) < 1e-6) from = v;
	}
	const SurfacePoint   at = {m.position[from], m.outgoing[from] / 3};
	const ExactDistances exact(m, at, 0.9 * surface.frame.scale);
	int                  above = 0, beside = 0;
	for (const auto& [v, d] : exact.all()) {
		const Vec3d p = place(v);
		if (p.z > 1 - 1e-6) {
			ASSERT_NEAR(d / surface.frame.scale, length(p - Vec3d(0.5, 0.5, 1)), 1e-6);
			++above;
		}
		else if (p.x < 1e-6) {
			ASSERT_LE(d / surface.frame.scale, std::hypot(0.5 + 1 - p.z, p.y - 0.5) + 1e-6);
			++beside;
		}
	}
	EXPECT_GT(above, 30);
	EXPECT_GT(beside, 5);
}

} // namespace

} // namespace gpr::test
