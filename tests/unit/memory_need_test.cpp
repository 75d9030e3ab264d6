// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/split_edges.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/pages.h>
#include <vcg_extras/core/input/memory_need.h>
#include <vcg_extras/core/remesh.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

TriangleMesh drawnOut(TriangleMesh mesh, double factor)
{
	for (Vec3d& p : mesh.positions)
		p.x *= factor;
	return mesh;
}

/// Squat faces, needles, faces of all lengths, and some faces without splits.
std::vector<TriangleMesh> shapes()
{
	Random random(3);
	return {grid(2, 2),
			grid(1, 300),
			grid(40, 1, 1, 0.001),
			drawnOut(icosphere(2), 100),
			drawnOut(icosphere(2), 1000),
			uvSphere(4, 40),
			joined(icosphere(3), scaled(grid(1, 1), 100)),
			noisySphere(3, 0.3, random)};
}

TEST(MemoryNeed, FacesAfterSplittingAreForeseenWithinAFactorOfTwo)
{
	Workers workers(2, nullptr);
	for (const TriangleMesh& shape : shapes()) {
		for (const float longest : {0.5f, 0.1f, 0.013f, 0.004f}) {
			IndexedMesh  mesh     = loaded(shape, workers);
			const double foreseen = facesAfterSplitting(
				mesh, findLongFaces(mesh, measureFaces(mesh, workers), longest, workers), longest);
			splitLongEdges(mesh, longest, 1 << 24, workers);
			EXPECT_LE(foreseen, 2 * mesh.faceNum) << longest;
			EXPECT_GE(foreseen, 0.5 * mesh.faceNum) << longest;
		}
	}
}

TEST(MemoryNeed, MoreThanThereIsIsRefusedWithBothFigures)
{
	requireMemory(1e9, 2000000000);
	requireMemory(1e30, 0);
	try {
		requireMemory(95.4e9, 16200000000);
		FAIL() << "not refused";
	}
	catch (const Failure& failure) {
		EXPECT_EQ(failure.status, Status::OutOfMemory);
		EXPECT_NE(failure.message.find("95.4 GB"), std::string::npos) << failure.message;
		EXPECT_NE(failure.message.find("16.2 GB"), std::string::npos) << failure.message;
	}
}

/// On any machine, and before the allocation of such a mesh.
TEST(MemoryNeed, MoreVerticesThanAMeshMayHaveAreRefused)
{
	const TriangleMesh mesh = grid(2, 2);
	RemeshOptions      options;
	options.targetMode       = TargetMode::EdgeLength;
	options.targetEdgeLen    = 1e-9;
	const auto expectRefused = [](Status status, const std::string& message) {
		EXPECT_EQ(status, Status::OutOfMemory);
		EXPECT_NE(message.find("200,000,000 vertices"), std::string::npos) << message;
	};
	const RemeshResult remeshed = remesh(mesh.view(), options);
	expectRefused(remeshed.status, remeshed.message);
	const SamplingResult sampled = samplePoissonDisks(mesh.view(), options);
	expectRefused(sampled.status, sampled.message);
}

TEST(MemoryNeed, TheSystemTellsAnAmountThatMakesSense)
{
	const std::int64_t bytes = availableMemoryBytes();
	EXPECT_GT(bytes, 10 << 20) << "or these tests would not run";
	EXPECT_LT(bytes, std::int64_t(1) << 50);
}

} // namespace

} // namespace gpr::test
