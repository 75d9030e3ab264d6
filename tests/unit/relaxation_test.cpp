// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices move on the surface and its curves: barycentric, by the umbrella, conformal.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/mesh/sectors.h>
#include <vcg_extras/core/optimization/relaxation.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

// ---- umbrella

class Umbrella : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(Umbrella, MakesTrianglesMoreRegularOnTheSurface)
{
	Random random(GetParam());
	for (const TriangleMesh& mesh : {jitteredGrid(30, 0.35, random), torus(50, 20)}) {
		OnSurface          on(mesh);
		const double       shape  = on.meanShape();
		const HalfEdgeMesh before = copyOf(on.m());
		for (int step = 0; step < 3; ++step)
			smoothByUmbrella2(on.surface, on.result, on.workers);
		if (!on.boundary.curves.empty()) {
			EXPECT_GT(on.meanShape(), shape + 0.01);
		}
		on.expectOnSurface();
		for (int f = 0; f < before.faceNum; ++f)
			ASSERT_GT(dot(before.faceNormal(f), on.m().faceNormal(f)), 0.0f) << "face " << f;
		for (int v = 0; v < before.vertexNum; ++v) {
			if (before.isBorderVertex(v)) {
				EXPECT_TRUE(before.position[v] == on.m().position[v]);
			}
		}
	}
}

TEST_P(Umbrella, DoesNotDependOnThreads)
{
	Random random(GetParam());
	expectSameForAnyThreads(jitteredGrid(70, 0.35, random), [](OnSurface& on, Workers& workers) {
		for (int step = 0; step < 3; ++step)
			smoothByUmbrella2(on.surface, on.result, workers);
	});
}

INSTANTIATE_TEST_SUITE_P(Seeds, Umbrella, ::testing::ValuesIn(testSeeds(3)));

TEST(UmbrellaKeeps, VerticesOnCreasesInPlace)
{
	OnSurface          on(cube(8));
	const HalfEdgeMesh before = copyOf(on.m());
	const Buffer<char> flat   = findFlatVertices(on.result.mesh, on.workers);
	smoothByUmbrella2(on.surface, on.result, on.workers);
	for (int v = 0; v < before.vertexNum; ++v) {
		if (flat[v] == 0) {
			EXPECT_TRUE(before.position[v] == on.m().position[v]);
		}
	}
}

// ---- relaxation

class RelaxOnce : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(RelaxOnce, MakesTrianglesMoreRegularAndTurnsNone)
{
	Random random(GetParam());
	for (const TriangleMesh& mesh :
		 {jitteredGrid(30, 0.35, random), uvSphere(20, 40), torus(50, 20)}) {
		OnSurface          on(mesh);
		const double       shape  = on.meanShape();
		const HalfEdgeMesh before = copyOf(on.m());
		relaxOnce(on.surface, on.result, on.workers);
		if (!on.boundary.curves.empty()) {
			EXPECT_GT(on.meanShape(), shape + 0.01);
		}
		on.expectOnSurface();
		int moved = 0;
		for (int f = 0; f < before.faceNum; ++f)
			ASSERT_GT(dot(before.faceNormal(f), on.m().faceNormal(f)), 0.0f) << "face " << f;
		for (int v = 0; v < before.vertexNum; ++v) {
			const bool stays = before.position[v] == on.m().position[v];
			moved += !stays;
			if (before.isBorderVertex(v)) {
				EXPECT_TRUE(stays);
			}
		}
		EXPECT_GT(moved, before.vertexNum / 2);
	}
}

/// Among long triangles the barycentre of a ring may be invisible from its vertex: such moves have
/// to be taken back.
TEST_P(RelaxOnce, TurnsNoFaceAmongPoorTrianglesEither)
{
	Random    random(GetParam());
	OnSurface on(jitteredGrid(30, 0.45, random));
	scramble(on.m(), random);
	const HalfEdgeMesh before = copyOf(on.m());
	relaxOnce(on.surface, on.result, on.workers);
	for (int f = 0; f < before.faceNum; ++f)
		ASSERT_GT(dot(before.faceNormal(f), on.m().faceNormal(f)), 0.0f) << "face " << f;
	on.expectOnSurface();
}

TEST_P(RelaxOnce, DoesNotDependOnThreads)
{
	Random random(GetParam());
	expectSameForAnyThreads(jitteredGrid(70, 0.35, random), [](OnSurface& on, Workers& workers) {
		for (int step = 0; step < 3; ++step)
			relaxOnce(on.surface, on.result, workers);
	});
}

INSTANTIATE_TEST_SUITE_P(Seeds, RelaxOnce, ::testing::ValuesIn(testSeeds(3)));

TEST(RelaxOnceKeeps, VerticesOnCreasesInPlace)
{
	OnSurface          on(cube(8));
	const Buffer<char> flat = findFlatVertices(on.result.mesh, on.workers);
	relaxOnce(on.surface, on.result, on.workers);
	for (int v = 0; v < on.m().vertexNum; ++v) {
		const Vec3d p = on.surface.frame.toCaller(on.surface.mesh.position[v]);
		const int   extreme =
			int(p.x == 0 || p.x == 1) + int(p.y == 0 || p.y == 1) + int(p.z == 0 || p.z == 1);
		EXPECT_EQ(flat[v] != 0, extreme == 1);
		if (extreme > 1) {
			EXPECT_EQ(on.m().position[v], on.surface.mesh.position[v]);
		}
	}
}

// ---- conformal

class Conformal : public ::testing::TestWithParam<std::uint32_t> {};

void fixCornersOfUnitSquare(OnSurface& on)
{
	for (ResultVertex& v : on.result.vertex) {
		const Vec3d p = on.surface.frame.toCaller(v.point.position);
		v.isCorner    = (p.x == 0 || p.x == 1) && (p.y == 0 || p.y == 1);
	}
}

/// A lattice whose points are moved by two long waves of random offset, fading towards the border.
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

/// Any relaxation damps short waves; the momentum serves long waves.
TEST_P(Conformal, TenStepsDampLongWavesMoreThanTenRelaxations)
{
	Random       random(GetParam()), again(GetParam());
	OnSurface    plain(wavyLattice(40, random)), on(wavyLattice(40, again));
	const double area = factsOf(meshOf(on.m())).area, before = 1 - on.meanShape();
	for (int step = 0; step < 10; ++step)
		relaxOnce(plain.surface, plain.result, plain.workers);
	relaxConformally(on.surface, on.boundary, 10, on.result, on.workers);
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
	relaxConformally(on.surface, on.boundary, 6, on.result, on.workers);
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
		relaxConformally(on.surface, on.boundary, 7, on.result, workers);
	});
}

TEST_P(Conformal, NoFaceTurnsAmongPoorTriangles)
{
	Random    random(GetParam());
	OnSurface on(jitteredGrid(30, 0.45, random));
	scramble(on.m(), random);
	const HalfEdgeMesh before = copyOf(on.m());
	relaxConformally(on.surface, on.boundary, 1, on.result, on.workers);
	for (int f = 0; f < on.m().faceNum; ++f)
		ASSERT_GT(on.m().faceNormal(f).z * before.faceNormal(f).z, 0.0f) << "face " << f;
	on.expectOnSurface();
}

INSTANTIATE_TEST_SUITE_P(Seeds, Conformal, ::testing::ValuesIn(testSeeds(3)));

/// Longest edge over shortest edge, without borders.
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

/// The lattice under the exponential function: nearly equilateral triangles that grow by a fifth
/// from row to row.
TriangleMesh growingLattice()
{
	TriangleMesh mesh = lattice(20, 12);
	for (Vec3d& p : mesh.positions) {
		const std::complex<double> z =
			std::exp(0.2 * std::complex<double>(p.y, p.x - 0.5 * p.y / std::sqrt(0.75)));
		p = {z.real(), z.imag(), 0};
	}
	return mesh;
}

/// The energy ignores sizes, so triangles keep their sizes; barycentres would pull the vertices
/// towards the larger triangles.
TEST(ConformalKeeps, TheGradingOfAMesh)
{
	OnSurface   on(growingLattice());
	const float before = grading(on.m());
	for (ResultVertex& v : on.result.vertex)
		v.isCorner = v.curve >= 0;
	relaxConformally(on.surface, on.boundary, 10, on.result, on.workers);
	EXPECT_GT(before, 4);
	EXPECT_NEAR(grading(on.m()) / before, 1, 0.05f);
}

/// The power of the distance from the origin by which the lengths of inner edges grow.
double growth(const HalfEdgeMesh& m)
{
	double x = 0, y = 0, xx = 0, xy = 0, n = 0;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (m.isBorderVertex(m.origin[h]) || m.isBorderVertex(m.target(h))) continue;
		const Vec3f  a = m.position[m.origin[h]], b = m.position[m.target(h)];
		const double at = std::log(double(length(a + b))), edge = std::log(double(length(b - a)));
		x += at;
		y += edge;
		xx += at * at;
		xy += at * edge;
		n += 1;
	}
	return (n * xy - x * y) / (n * xx - x * x);
}

/// Edges in proportion to the distance from the origin, as the sizes ask, stay; barycentres without
/// sizes would take away a fifth of the growth.
TEST(RelaxOnceKeeps, TheGradingOfAMeshThatHasSizes)
{
	OnSurface           on(growingLattice());
	const HalfEdgeMesh& m = on.surface.mesh;
	on.surface.size.reset(m.vertexNum);
	for (int v = 0; v < m.vertexNum; ++v)
		on.surface.size[v] = length(m.position[v]);
	EXPECT_NEAR(growth(on.m()), 1, 0.01);
	for (int step = 0; step < 20; ++step)
		relaxOnce(on.surface, on.result, on.workers);
	EXPECT_NEAR(growth(on.m()), 1, 0.12);
}

} // namespace

} // namespace gpr::test
