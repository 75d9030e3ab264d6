// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The stages for a regular result: valences, glide of dislocations.

#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <vcg_extras/core/mesh/coloured_grid.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/sectors.h>
#include <vcg_extras/core/optimization/delaunay_flips.h>
#include <vcg_extras/core/optimization/valence_glide.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

int energyOf(const HalfEdgeMesh& m, Workers& workers)
{
	int sum = 0;
	for (int n : correctedValences(m, workers))
		sum += squaredDefect(n);
	return sum;
}

/// The inner edge nearest to the middle of all vertices.
int middleEdge(const HalfEdgeMesh& m)
{
	Vec3f sum;
	for (int v = 0; v < m.vertexNum; ++v)
		sum += m.position[v];
	const Vec3f middle  = sum * (1 / float(m.vertexNum));
	int         nearest = 0;
	float       least   = 1e30f;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		const Vec3f centre = (m.position[m.origin[h]] + m.position[m.target(h)]) * 0.5f;
		if (m.opposite[h] < 0 || length(centre - middle) >= least) continue;
		least   = length(centre - middle);
		nearest = h;
	}
	return nearest;
}

TEST(ValenceEnergy, IsZeroOnALatticeAndTwelveOnAnIcosphere)
{
	OnSurface flat(lattice(20, 20)), round(icosphere(3));
	// The borders of the parallelogram are straight, its corners 60° and 120°.
	EXPECT_EQ(energyOf(flat.m(), flat.workers), 0);
	EXPECT_EQ(energyOf(round.m(), round.workers), 12);
}

TEST(ValenceEnergy, FlipEnergyIsWhatAFlipChanges)
{
	Random    random(3);
	OnSurface on(jitteredGrid(20, 0.3, random));
	scramble(on.m(), random);
	HalfEdgeMesh& m = on.m();
	int           n = 0;
	for (int h = 0; h < m.halfEdgeNum(); h += 7) {
		// At a border angles count, too, and flips that fold a face change these angles.
		if (m.isBorderVertex(m.origin[h]) || m.isBorderVertex(m.target(h))) continue;
		if (m.isBorderVertex(m.apex(h)) || m.isBorderVertex(m.apex(m.opposite[h]))) continue;
		if (!canFlip(m, h)) continue;
		const Buffer<int> valence = correctedValences(m, on.workers);
		const int         before = energyOf(m, on.workers), change = flipEnergy(m, valence, h);
		flip(m, h);
		EXPECT_EQ(energyOf(m, on.workers), before + change);
		++n;
	}
	EXPECT_GT(n, 50);
}

/// Flips that leave the energy, until the two dislocations of the first flip are `flips` flips
/// apart: each flip moves the pair as far from its start as possible.
void separateDislocations(OnSurface& on, int first, int flips)
{
	HalfEdgeMesh& m      = on.m();
	const Vec3f   origin = m.position[m.origin[first]];
	flip(m, first);
	for (int i = 1; i < flips; ++i) {
		const Buffer<int> valence = correctedValences(m, on.workers);
		int               best    = -1;
		float             far     = 0;
		for (int h = 0; h < m.halfEdgeNum(); ++h) {
			if (m.opposite[h] < h || flipEnergy(m, valence, h) != 0 || !canFlip(m, h)) continue;
			if (valence[m.apex(h)] > 5 && valence[m.apex(m.opposite[h])] > 5) continue;
			if (!flipKeepsShape(m, h)) continue;
			const float distance =
				length(m.position[m.origin[h]] + m.position[m.target(h)] - origin - origin);
			if (distance <= far) continue;
			far  = distance;
			best = h;
		}
		ASSERT_GE(best, 0);
		flip(m, best);
	}
}

class Dislocations : public ::testing::TestWithParam<int> {};

TEST_P(Dislocations, GlideTogetherAndVanish)
{
	OnSurface on(lattice(24, 24));
	separateDislocations(on, middleEdge(on.m()), GetParam());
	ASSERT_EQ(energyOf(on.m(), on.workers), 4) << "two pairs of a 5 and a 7";
	const HalfEdgeMesh before = copyOf(on.m());
	EXPECT_EQ(glideDislocations(on.result, on.workers, GetParam()), 1);
	EXPECT_EQ(energyOf(on.m(), on.workers), 0);
	EXPECT_EQ(edgesNotDelaunay(on.m()), 0) << "the lattice is back";
	EXPECT_TRUE(std::equal(before.position.begin(), before.position.end(), on.m().position.begin()))
		<< "and no vertex has moved";
	on.expectSound();
}

TEST_P(Dislocations, StayWhereTheLookAheadIsTooShort)
{
	if (GetParam() == 1) return;
	OnSurface on(lattice(24, 24));
	separateDislocations(on, middleEdge(on.m()), GetParam());
	const int notDelaunay = edgesNotDelaunay(on.m());
	EXPECT_EQ(glideDislocations(on.result, on.workers, GetParam() - 1), 0);
	EXPECT_EQ(on.result.flipNum, 0);
	EXPECT_EQ(energyOf(on.m(), on.workers), 4);
	EXPECT_EQ(edgesNotDelaunay(on.m()), notDelaunay) << "trial flips are undone";
	on.expectSound();
}

INSTANTIATE_TEST_SUITE_P(Flips, Dislocations, ::testing::Values(1, 2, 3, 4, 5));

class Glide : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(Glide, LowersTheEnergyWithoutFoldingOrMovingAnything)
{
	Random    random(GetParam());
	OnSurface on(jitteredGrid(60, 0.3, random));
	flipToDelaunay(on.result, on.workers);
	const int          energy = energyOf(on.m(), on.workers);
	const TriangleMesh before = meshOf(on.m());
	const HalfEdgeMesh places = copyOf(on.m());
	const double       angle  = on.minAngleDeg();
	EXPECT_GT(glideDislocations(on.result, on.workers), 20);
	EXPECT_LT(energyOf(on.m(), on.workers), energy * 9 / 10);
	EXPECT_GE(on.minAngleDeg(), std::min(angle, 16.9));
	EXPECT_TRUE(hasSameTopology(meshOf(on.m()), before));
	EXPECT_TRUE(
		std::equal(places.position.begin(), places.position.end(), on.m().position.begin()));
	EXPECT_NEAR(factsOf(meshOf(on.m())).area, factsOf(before).area, 1e-5) << "nothing overlaps";
	on.expectSound();
}

TEST_P(Glide, DoesNotDependOnThreads)
{
	Random random(GetParam());
	expectSameForAnyThreads(jitteredGrid(90, 0.35, random), [](OnSurface& on, Workers& workers) {
		for (int round = 0; round < 3; ++round)
			glideDislocations(on.result, workers);
	});
}

INSTANTIATE_TEST_SUITE_P(Seeds, Glide, ::testing::ValuesIn(testSeeds(3)));

/// Edges over the fold have vertices on the fold, where the surface is not flat.
TEST(GlideKeeps, ASharpFold)
{
	OnSurface on(bentSheet(24, 1.8));
	glideDislocations(on.result, on.workers);
	const double area = 1;
	EXPECT_NEAR(factsOf(meshOf(on.m())).area / std::pow(on.surface.frame.scale, 2), area, 1e-5);
	on.expectSound();
}

TEST(ColouredGrid, ShareOutEveryVertexAndNeverReachTheSame)
{
	OnSurface        on(icosphere(4));
	std::vector<int> all;
	for (int v = 0; v < on.m().vertexNum; v += 2)
		all.push_back(v);
	const ColouredGrid cells = cutIntoGridCells(on.m(), all, 8 * on.result.idealEdge);
	std::vector<int>   seen;
	int                cellNum = 0;
	for (const std::vector<GridCell>& colour : cells.byColour) {
		std::vector<int> owner(on.m().vertexNum, -1);
		for (const GridCell& cell : colour) {
			++cellNum;
			for (int i = cell.begin; i < cell.end; ++i) {
				seen.push_back(cells.vertices[i]);
				EXPECT_TRUE(cell.reaches(on.m().position[cells.vertices[i]]));
			}
			for (int v = 0; v < on.m().vertexNum; ++v) {
				if (!cell.reaches(on.m().position[v])) continue;
				EXPECT_EQ(owner[v], -1) << "vertex " << v << " is reached from two cells";
				owner[v] = cellNum;
			}
		}
	}
	EXPECT_GT(cellNum, 20);
	std::sort(seen.begin(), seen.end());
	EXPECT_EQ(seen, all);
}

} // namespace

} // namespace gpr::test
