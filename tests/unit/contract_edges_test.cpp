// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/input/contract_edges.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

struct Contracted {
	Workers      workers{2, nullptr};
	CleanCounts  counts;
	TriangleMesh after;

	explicit Contracted(const TriangleMesh& before)
	{
		IndexedMesh mesh = loaded(before, workers);
		contractEdgesWithoutLength(mesh, workers, counts);
		after = meshOf(mesh);
	}
};

/// A square of nx × ny cells whose column at x has no width.
TriangleMesh withFlatColumn(int nx, int ny, int column)
{
	TriangleMesh mesh = grid(nx, ny);
	for (int j = 0; j <= ny; ++j) {
		const std::size_t row                         = std::size_t(j) * std::size_t(nx + 1);
		mesh.positions[row + std::size_t(column) + 1] = mesh.positions[row + std::size_t(column)];
	}
	return mesh;
}

TEST(ContractEdges, AStripWithoutWidthIsGone)
{
	const Contracted r(withFlatColumn(5, 4, 2));
	EXPECT_EQ(r.counts.contractedEdges, 5);
	EXPECT_EQ(r.counts.zeroAreaFaces, 8);
	EXPECT_TRUE(isSoundSurface(r.after));
	EXPECT_TRUE(hasSameTopology(r.after, grid(4, 4)));
	EXPECT_EQ(r.after.vertexNum(), grid(4, 4).vertexNum());
}

TEST(ContractEdges, StripsSideBySideAreGone)
{
	TriangleMesh mesh = withFlatColumn(6, 4, 2);
	for (int j = 0; j <= 4; ++j)
		mesh.positions[std::size_t(j * 7 + 4)] = mesh.positions[std::size_t(j * 7 + 2)];
	const Contracted r(mesh);
	EXPECT_EQ(r.counts.contractedEdges, 10);
	EXPECT_TRUE(isSoundSurface(r.after));
	EXPECT_TRUE(hasSameTopology(r.after, grid(4, 4)));
}

TEST(ContractEdges, AMeshWithoutSuchEdgesStaysAsItIs)
{
	const Contracted r(icosphere(2));
	EXPECT_EQ(r.counts.contractedEdges, 0);
	EXPECT_FALSE(r.counts.changedInput());
	EXPECT_EQ(r.after.triangles, icosphere(2).triangles);
}

/// A neck without girth: its vertices could only be joined by cutting the tube in two.
TEST(ContractEdges, ANeckThatJoinsTwoPartsStays)
{
	TriangleMesh tube = closedCylinder(8, 6, 1, 6);
	for (int i = 0; i < 8; ++i)
		tube.positions[std::size_t(3 * 8 + i)] = {0, 0, 3};
	const Contracted r(tube);
	EXPECT_EQ(r.counts.contractedEdges, 0);
	EXPECT_TRUE(hasSameTopology(r.after, tube));
}

/// A cell between two holes whose only edge has no length.
TEST(ContractEdges, ABridgeBetweenTwoHolesStays)
{
	TriangleMesh mesh;
	mesh.positions = {{-2, -1, 0}, {0, -1, 0}, {2, -1, 0}, {-1, 0, 0}, {0, 0, 0},
					  {0, 0, 0},   {1, 0, 0},  {-2, 1, 0}, {0, 1, 0},  {2, 1, 0}};
	// Two triangles below and above the edge 4-5, with only this edge in common.
	mesh.triangles = {4, 1, 5, 5, 8, 4};
	const Contracted r(mesh);
	EXPECT_EQ(r.counts.contractedEdges, 0);
	EXPECT_EQ(r.after.faceNum(), 2u);
}

TEST(ContractEdges, AnEdgeOfTheBorderIsContracted)
{
	TriangleMesh mesh = grid(3, 3);
	mesh.positions[1] = mesh.positions[0];
	const Contracted r(mesh);
	EXPECT_EQ(r.counts.contractedEdges, 1);
	EXPECT_TRUE(isSoundSurface(r.after));
	EXPECT_TRUE(hasSameTopology(r.after, mesh));
}

/// The apex of a cone as a ring of vertices at one place, covered by faces.
TEST(ContractEdges, ACapWithoutSizeBecomesATip)
{
	TriangleMesh cone = closedCylinder(6, 3, 1, 3);
	for (int i = 0; i < 6; ++i)
		cone.positions[std::size_t(3 * 6 + i)] = {0, 0, 3};
	const Contracted r(cone);
	EXPECT_EQ(r.counts.contractedEdges, 6);
	EXPECT_TRUE(isSoundSurface(r.after));
	EXPECT_TRUE(hasSameTopology(r.after, icosphere(0)));
}

/// A hole without area is the end of a seam that was not sewn.
TEST(ContractEdges, ASlitOfThreeEdgesIsClosed)
{
	const TriangleMesh whole = icosphere(2);
	const TriangleMesh slit  = withSlit(whole, 50);
	ASSERT_EQ(factsOf(slit).boundaryLoops, 1);
	ASSERT_TRUE(factsOf(slit).isManifold());
	const Contracted r(slit);
	EXPECT_EQ(r.counts.contractedEdges, 1);
	EXPECT_TRUE(isSoundSurface(r.after));
	EXPECT_TRUE(hasSameTopology(r.after, whole));
}

/// The three edges of a single face are no hole.
TEST(ContractEdges, ASingleFaceIsNoSlitAndGone)
{
	TriangleMesh face;
	face.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
	face.triangles = {0, 1, 2};
	const Contracted r(joined(grid(2, 2), face));
	EXPECT_EQ(r.counts.contractedEdges, 1);
	EXPECT_EQ(factsOf(r.after).components, 1);
}

TEST(ContractEdges, RandomOnesKeepTheTopology)
{
	std::int64_t contracted = 0;
	for (std::uint32_t seed : testSeeds(200)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random       random(seed);
		TriangleMesh mesh = randomSurface(random);
		for (int i = 0; i < 12; ++i) {
			const std::size_t f = std::size_t(random.below(int(mesh.faceNum())));
			const std::size_t a = 3 * f + std::size_t(random.below(3));
			const std::size_t b = 3 * f + std::size_t(random.below(3));
			mesh.positions[std::size_t(mesh.triangles[a])] =
				mesh.positions[std::size_t(mesh.triangles[b])];
		}
		const Contracted r(mesh);
		ASSERT_TRUE(factsOf(r.after).isManifold());
		ASSERT_TRUE(hasSameTopology(r.after, mesh));
		contracted += r.counts.contractedEdges;
	}
	EXPECT_GT(contracted, 1000);
}

} // namespace

} // namespace gpr::test
