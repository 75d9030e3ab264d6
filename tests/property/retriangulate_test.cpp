// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Retriangulation from given samples: they become the vertices, the topology stays.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

RemeshOptions someOptions()
{
	RemeshOptions options;
	options.threads = 2;
	return options;
}

TEST(Retriangulate, MakesTheSamplesOfAClosedSurfaceItsVertices)
{
	for (const TriangleMesh& mesh : {icosphere(4), torus(90, 46)}) {
		const SamplingResult s = samplePoissonDisks(mesh.view(), someOptions());
		ASSERT_EQ(s.status, Status::Ok);
		const RemeshResult r = retriangulate(mesh.view(), s.points, someOptions());
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
		EXPECT_EQ(r.mesh.vertexNum(), s.points.size() + std::size_t(r.report.leftoverVertexNum));
		EXPECT_LE(double(r.report.leftoverVertexNum), 0.01 * double(s.points.size()));
		EXPECT_EQ(r.report.samplesMoved, 0);
		for (const Vec3d& p : s.points)
			ASSERT_LT(distanceToNearest(r.mesh.positions, p), 1e-5);
	}
}

TEST(Retriangulate, TellsWhichSampleAVertexIsAndKeepsItsCoordinates)
{
	const TriangleMesh   mesh = torus(90, 46);
	const SamplingResult s    = samplePoissonDisks(mesh.view(), someOptions());
	const RemeshResult   r    = retriangulate(mesh.view(), s.points, someOptions());
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	ASSERT_EQ(r.sampleOf.size(), r.mesh.vertexNum());
	std::vector<int> seen(s.points.size(), 0);
	for (std::size_t v = 0; v < r.sampleOf.size(); ++v) {
		if (r.sampleOf[v] < 0) continue;
		ASSERT_LT(std::size_t(r.sampleOf[v]), s.points.size());
		++seen[r.sampleOf[v]];
		ASSERT_LT(length(r.mesh.positions[v] - s.points[r.sampleOf[v]]), 1e-6);
	}
	for (int n : seen)
		ASSERT_EQ(n, 1) << "every sample is one vertex";
}

TEST(Retriangulate, PutsSamplesOnTheSurfaceAndTellsHowFar)
{
	const TriangleMesh   mesh = icosphere(4);
	const SamplingResult s    = samplePoissonDisks(mesh.view(), someOptions());
	std::vector<Vec3d>   lifted;
	for (const Vec3d& p : s.points)
		lifted.push_back(p * 1.01);
	const RemeshResult r = retriangulate(mesh.view(), lifted, someOptions());
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.report.samplesMoved, std::int64_t(lifted.size()));
	EXPECT_NEAR(r.report.largestSampleMove, 0.01, 0.002);
	for (const Vec3d& p : r.mesh.positions)
		EXPECT_LE(length(p), 1 + 1e-5);
}

TEST(Retriangulate, KeepsTheTopologyWhereSamplesAreTooFew)
{
	const TriangleMesh mesh = torus(40, 20);
	const RemeshResult r    = retriangulate(mesh.view(), {{1.4, 0, 0}}, someOptions());
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_GE(r.report.leftoverVertexNum, 6);
}

/// Vertices of a component without a sample belong to no cell. The component stays, with the fewest
/// vertices that its topology allows.
TEST(Retriangulate, KeepsComponentsWithoutASample)
{
	const TriangleMesh   sampled = torus(90, 46);
	const SamplingResult s       = samplePoissonDisks(sampled.view(), someOptions());
	TriangleMesh         mesh    = joined(shifted(icosphere(3), {9, 0, 0}), sampled);
	mesh                         = joined(mesh, shifted(grid(20, 20), {0, 9, 0}));
	for (Preset preset : {Preset::Default, Preset::Fast, Preset::Paper}) {
		RemeshOptions options = someOptions();
		options.preset        = preset;
		const RemeshResult r  = retriangulate(mesh.view(), s.points, options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
		EXPECT_TRUE(isSoundSurface(r.mesh));
		const std::int64_t more = std::int64_t(r.mesh.vertexNum() - s.points.size());
		EXPECT_EQ(r.report.leftoverVertexNum, more);
		EXPECT_EQ(more, 4 + 3) << "a tetrahedron and a triangle";
	}
}

TEST(Retriangulate, KeepsTheBorderOfAnOpenSurface)
{
	const TriangleMesh   mesh = openCylinder(60, 60, 0.5, 1.5);
	const SamplingResult s    = samplePoissonDisks(mesh.view(), someOptions());
	const RemeshResult   r    = retriangulate(mesh.view(), s.points, someOptions());
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
}

TEST(Retriangulate, RefusesWhatAreNoSamples)
{
	const TriangleMesh mesh = icosphere(2);
	EXPECT_EQ(retriangulate(mesh.view(), {}, someOptions()).status, Status::BadOptions);
	EXPECT_EQ(retriangulate(mesh.view(), {{NAN, 0, 0}}, someOptions()).status, Status::BadOptions);
}

TEST(Retriangulate, DoesNotDependOnThreads)
{
	const TriangleMesh   mesh    = torus(90, 46);
	const SamplingResult s       = samplePoissonDisks(mesh.view(), someOptions());
	RemeshOptions        options = someOptions();
	options.threads              = 1;
	const RemeshResult one       = retriangulate(mesh.view(), s.points, options);
	for (int threads = 2; threads <= 4; ++threads) {
		options.threads      = threads;
		const RemeshResult r = retriangulate(mesh.view(), s.points, options);
		EXPECT_TRUE(r.mesh.positions == one.mesh.positions);
		EXPECT_EQ(r.mesh.triangles, one.mesh.triangles);
	}
}

} // namespace

} // namespace gpr::test
