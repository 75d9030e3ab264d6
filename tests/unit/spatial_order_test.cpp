// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/spatial_order.h>

#include <algorithm>
#include <array>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

using Corners = std::array<std::array<float, 3>, 3>;

/// A face by the places of its corners, from the smallest corner on: independent of numbering, but
/// not of orientation.
Corners placesOf(const TriangleMesh& mesh, std::size_t f)
{
	Corners c;
	for (int k = 0; k < 3; ++k) {
		const Vec3f p = Vec3f(mesh.positions[mesh.triangles[3 * f + k]]);
		c[k]          = {p.x, p.y, p.z};
	}
	std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
	return c;
}

std::vector<Corners> sortedPlaces(const TriangleMesh& mesh)
{
	std::vector<Corners> faces;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f)
		faces.push_back(placesOf(mesh, f));
	std::sort(faces.begin(), faces.end());
	return faces;
}

class OrderSpatially : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(OrderSpatially, KeepsTheSurfaceAndPutsItInMortonOrder)
{
	Random             random(GetParam());
	Workers            workers(2, nullptr);
	const TriangleMesh input  = randomSurface(random);
	IndexedMesh        m      = loaded(input, workers);
	const TriangleMesh before = meshOf(m);
	Buffer<int>        faceStart;
	const MortonGrid   grid  = orderSpatially(m, workers, faceStart);
	const TriangleMesh after = meshOf(m);

	EXPECT_EQ(sortedPlaces(after), sortedPlaces(before)) << "the same faces, orientation included";
	for (int v = 1; v < m.vertexNum; ++v) {
		ASSERT_LE(grid.cell(m.position[v - 1], grid.level), grid.cell(m.position[v], grid.level));
	}
	for (std::size_t f = 0; f < after.faceNum(); ++f)
		ASSERT_EQ(placesOf(after, f), placesOf(before, m.sourceFace[f]))
			<< "sourceFace moves along";
}

TEST_P(OrderSpatially, FacesLieByTheirFirstCornerWhichIsTheirSmallest)
{
	Random      random(GetParam());
	Workers     workers(2, nullptr);
	IndexedMesh m = loaded(randomSurface(random), workers);
	Buffer<int> faceStart;
	orderSpatially(m, workers, faceStart);
	ASSERT_EQ(int(faceStart.size()), m.vertexNum + 1);
	EXPECT_EQ(faceStart[0], 0);
	EXPECT_EQ(faceStart[m.vertexNum], m.faceNum);
	for (int v = 0; v < m.vertexNum; ++v) {
		for (int f = faceStart[v]; f < faceStart[v + 1]; ++f) {
			ASSERT_EQ(m.triangle[3 * f], v);
			ASSERT_LT(v, m.triangle[3 * f + 1]);
			ASSERT_LT(v, m.triangle[3 * f + 2]);
		}
	}
}

TEST_P(OrderSpatially, DoesNotDependOnThreads)
{
	TriangleMesh first;
	for (int threads = 1; threads <= 4; ++threads) {
		Random      random(GetParam());
		Workers     workers(threads, nullptr);
		IndexedMesh m = loaded(subdivided(randomSurface(random)), workers);
		Buffer<int> faceStart;
		orderSpatially(m, workers, faceStart);
		const TriangleMesh mesh = meshOf(m);
		if (threads == 1) first = mesh;
		EXPECT_EQ(mesh.triangles, first.triangles);
		EXPECT_TRUE(mesh.positions == first.positions);
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, OrderSpatially, ::testing::ValuesIn(testSeeds(6)));

/// The Z of Morton's order: x is the lowest bit, then y, then z.
TEST(MortonGrid, NumbersTheEightCellsOfACube)
{
	MortonGrid g;
	g.low      = {0, 0, 0};
	g.cubeSize = 1;
	for (int i = 0; i < 8; ++i) {
		const Vec3f p(0.25f + 0.5f * float(i & 1), 0.25f + 0.5f * float(i >> 1 & 1),
					  0.25f + 0.5f * float(i >> 2));
		EXPECT_EQ(g.cell(p, 1), std::uint64_t(i));
	}
	EXPECT_FLOAT_EQ(g.cellSize(3), 0.125f);
	EXPECT_EQ(g.cell({1, 1, 1}, 1), 7u) << "the far corner falls into the last cell";
	EXPECT_EQ(g.cell({-1, -1, -1}, 1), 0u) << "points outside are taken to the edge";
}

} // namespace

} // namespace gpr::test
