// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The stages that make a result regular: valences, glide of dislocations, conformal steps.

#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/valence_energy.h>
#include <vcg_extras/core/mesh/work_cells.h>
#include <vcg_extras/core/optimization/delaunay_flips.h>
#include <vcg_extras/core/optimization/relaxation.h>
#include <vcg_extras/core/optimization/valence_glide.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// Equilateral triangles of side 1, nx by ny pairs of them, in a parallelogram.
TriangleMesh lattice(int nx, int ny)
{
	TriangleMesh mesh;
	const auto   index = [&](int i, int j) { return j * (nx + 1) + i; };
	for (int j = 0; j <= ny; ++j) {
		for (int i = 0; i <= nx; ++i)
			mesh.positions.push_back({i + 0.5 * j, std::sqrt(0.75) * j, 0});
	}
	for (int j = 0; j < ny; ++j) {
		for (int i = 0; i < nx; ++i) {
			const int a = index(i, j), b = index(i + 1, j);
			const int c = index(i, j + 1), d = index(i + 1, j + 1);
			mesh.triangles.insert(mesh.triangles.end(), {a, b, c, b, d, c});
		}
	}
	return mesh;
}

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
		// At a border angles count as well, which change where a flip folds a face.
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

/// Flips that leave the energy, until the two dislocations that the first one makes are `flips`
/// flips apart: each moves the pair that can get furthest from where it began.
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
			if (!flipKeepsShape(m, h, 0.3f, 0.8f)) continue;
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
	const double       angle  = on.leastAngleDeg();
	EXPECT_GT(glideDislocations(on.result, on.workers), 20);
	EXPECT_LT(energyOf(on.m(), on.workers), energy * 9 / 10);
	EXPECT_GE(on.leastAngleDeg(), std::min(angle, 16.9));
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

/// Edges over the fold have vertices that are not flat.
TEST(GlideKeeps, ASharpFold)
{
	OnSurface on(bentSheet(24, 1.8));
	glideDislocations(on.result, on.workers);
	const double area = 1;
	EXPECT_NEAR(factsOf(meshOf(on.m())).area / std::pow(on.surface.frame.scale, 2), area, 1e-5);
	on.expectSound();
}

TEST(WorkCells, ShareOutEveryVertexAndNeverReachTheSame)
{
	OnSurface        on(icosphere(4));
	std::vector<int> all;
	for (int v = 0; v < on.m().vertexNum; v += 2)
		all.push_back(v);
	const WorkCells  cells = cutIntoWorkCells(on.m(), all, 8 * on.result.idealEdge);
	std::vector<int> seen;
	int              cellNum = 0;
	for (const std::vector<WorkCell>& colour : cells.byColour) {
		std::vector<int> owner(on.m().vertexNum, -1);
		for (const WorkCell& cell : colour) {
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

class Conformal : public ::testing::TestWithParam<std::uint32_t> {};

void fixCornersOfUnitSquare(OnSurface& on)
{
	for (ResultVertex& v : on.result.vertex) {
		const Vec3d p = on.surface.frame.toCaller(v.anchor.position);
		v.isCorner    = (p.x == 0 || p.x == 1) && (p.y == 0 || p.y == 1);
	}
}

/// A lattice whose points are moved by two long waves, of random phase, that fade at its border.
TriangleMesh wavyLattice(int n, Random& random)
{
	TriangleMesh mesh  = lattice(n, n);
	const double pi    = 3.14159265358979;
	const double phase = random.between(0, 2 * pi);
	for (int j = 0; j <= n; ++j) {
		for (int i = 0; i <= n; ++i) {
			Vec3d&       p    = mesh.positions[j * (n + 1) + i];
			const double fade = std::sin(pi * i / n) * std::sin(pi * j / n);
			p.x += 1.5 * fade * std::sin(4 * pi * i / n + phase);
			p.y += 1.5 * fade * std::sin(4 * pi * j / n - phase);
		}
	}
	return mesh;
}

/// Short waves any relaxation damps; the momentum is there for the long ones.
TEST_P(Conformal, TenStepsDampLongWavesMoreThanTenRelaxations)
{
	Random       random(GetParam()), again(GetParam());
	OnSurface    plain(wavyLattice(40, random)), on(wavyLattice(40, again));
	const double area = factsOf(meshOf(on.m())).area, before = 1 - on.meanShape();
	for (int step = 0; step < 10; ++step)
		relaxOnce(plain.surface, plain.result, plain.workers);
	relaxConformally(on.surface, on.boundary, conformalSteps(10), on.result, on.workers);
	EXPECT_LT(1 - plain.meanShape(), 0.9 * before);
	EXPECT_LT(1 - on.meanShape(), 0.7 * (1 - plain.meanShape()));
	EXPECT_NEAR(factsOf(meshOf(on.m())).area / area, 1, 1e-3) << "nothing overlaps";
	on.expectSound();
	on.expectOnSurface();
}

TEST_P(Conformal, BorderVerticesSlideAlongTheBorderAndCornersStay)
{
	Random    random(GetParam());
	OnSurface on(jitteredGrid(30, 0.3, random));
	fixCornersOfUnitSquare(on);
	const HalfEdgeMesh before = copyOf(on.m());
	relaxConformally(on.surface, on.boundary, conformalSteps(6), on.result, on.workers);
	int moved = 0;
	for (int v = 0; v < before.vertexNum; ++v) {
		if (!before.isBorderVertex(v)) continue;
		const bool stays = before.position[v] == on.m().position[v];
		moved += !stays;
		if (on.result.vertex[v].isCorner) {
			EXPECT_TRUE(stays);
		}
		const Vec3d p = on.surface.frame.toCaller(on.m().position[v]);
		EXPECT_LT(std::min({std::abs(p.x), std::abs(p.x - 1), std::abs(p.y), std::abs(p.y - 1)}),
				  1e-5)
			<< "vertex " << v << " has left the border";
	}
	EXPECT_GT(moved, 30);
}

TEST_P(Conformal, DoesNotDependOnThreads)
{
	Random random(GetParam());
	expectSameForAnyThreads(jitteredGrid(70, 0.35, random), [](OnSurface& on, Workers& workers) {
		relaxConformally(on.surface, on.boundary, conformalSteps(7), on.result, workers);
	});
}

TEST_P(Conformal, NoFaceTurnsAmongPoorTriangles)
{
	Random    random(GetParam());
	OnSurface on(jitteredGrid(30, 0.45, random));
	scramble(on.m(), random);
	const HalfEdgeMesh before = copyOf(on.m());
	relaxConformally(on.surface, on.boundary, {1, 0, 1, untilDelaunay}, on.result, on.workers);
	for (int f = 0; f < on.m().faceNum; ++f)
		ASSERT_GT(on.m().faceNormal(f).z * before.faceNormal(f).z, 0.0f) << "face " << f;
	on.expectOnSurface();
}

INSTANTIATE_TEST_SUITE_P(Seeds, Conformal, ::testing::ValuesIn(testSeeds(3)));

/// Length of the longest edge over that of the shortest, borders left out.
float grading(const HalfEdgeMesh& m)
{
	float least = 1e30f, most = 0;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (m.isBorderVertex(m.origin[h]) || m.isBorderVertex(m.target(h))) continue;
		const float l = length(m.position[m.target(h)] - m.position[m.origin[h]]);
		least         = std::min(least, l);
		most          = std::max(most, l);
	}
	return most / least;
}

/// The lattice under the exponential function: triangles that grow by a fifth from row to row and
/// are nearly equilateral. Size is none of the energy's business, so they keep theirs; barycentres
/// would pull the vertices towards the larger triangles.
TEST(ConformalKeeps, TheGradingOfAMesh)
{
	TriangleMesh mesh = lattice(20, 12);
	for (Vec3d& p : mesh.positions) {
		const std::complex<double> z =
			std::exp(0.2 * std::complex<double>(p.y, p.x - 0.5 * p.y / std::sqrt(0.75)));
		p = {z.real(), z.imag(), 0};
	}
	OnSurface   on(mesh);
	const float before = grading(on.m());
	for (ResultVertex& v : on.result.vertex)
		v.isCorner = v.curve >= 0;
	relaxConformally(on.surface, on.boundary, conformalSteps(10), on.result, on.workers);
	EXPECT_GT(before, 4);
	EXPECT_NEAR(grading(on.m()) / before, 1, 0.05f);
}

} // namespace

} // namespace gpr::test
