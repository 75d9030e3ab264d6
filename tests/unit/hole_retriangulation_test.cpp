// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/retriangulation/hole_retriangulation.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr double pi = 3.14159265358979323846;

/// A fan of n triangles round vertex 0 over a whole turn or over `angle`; the points of the rim lie
/// at height z.
TriangleMesh fan(int n, double angle, double z)
{
	const bool   isClosed = angle >= 2 * pi;
	const int    places   = isClosed ? n : n + 1;
	TriangleMesh mesh{{{0, 0, 0}}, {}};
	for (int i = 0; i < places; ++i) {
		const double a = angle * i / n;
		mesh.positions.push_back({std::cos(a), std::sin(a), z});
	}
	for (int i = 0; i < n; ++i)
		mesh.triangles.insert(mesh.triangles.end(), {0, 1 + i, 1 + (i + 1) % places});
	return mesh;
}

double angleAtOrigin(const Vec2d& a, const Vec2d& b)
{
	return std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

class Fans : public ::testing::TestWithParam<int> {};

/// A cone is developable: lengths of the spokes stay, angles are alike and make a full turn.
TEST_P(Fans, OfAConeAreFlattenedToARegularPolygon)
{
	const int          n = GetParam();
	const double       z = 0.7, slant = std::sqrt(1 + z * z);
	const HalfEdgeMesh m = halfEdgesOf(fan(n, 2 * pi, z));
	VertexStar         star;
	std::vector<Vec2d> flat;
	collectStar(m, 0, star);
	const Vec3d normal = flattenStar(m, star, flat);
	ASSERT_EQ(int(flat.size()), n);
	for (int i = 0; i < n; ++i) {
		EXPECT_NEAR(std::hypot(flat[i].x, flat[i].y), slant, 1e-6);
		EXPECT_NEAR(angleAtOrigin(flat[i], flat[(i + 1) % n]), 2 * pi / n, 1e-6);
	}
	EXPECT_NEAR(normal.z, 1, 1e-6);
}

/// At a border, a fan of any angle becomes 180° wide.
TEST_P(Fans, AtABorderAreFlattenedToAHalfDisk)
{
	const int n = GetParam();
	for (const double angle : {0.4 * pi, pi, 1.7 * pi}) {
		const HalfEdgeMesh m = halfEdgesOf(fan(n, angle, 0));
		VertexStar         star;
		std::vector<Vec2d> flat;
		collectStar(m, 0, star);
		flattenStar(m, star, flat);
		ASSERT_EQ(int(flat.size()), n + 1);
		EXPECT_NEAR(flat[0].x, 1, 1e-6);
		EXPECT_NEAR(flat[n].x, -1, 1e-6);
		for (int i = 0; i < n; ++i)
			EXPECT_NEAR(angleAtOrigin(flat[i], flat[i + 1]), pi / n, 1e-6);
	}
}

/// Inside, the vertex goes and n - 2 triangles fill the polygon of its ring.
TEST_P(Fans, LoseTheirCentre)
{
	const int          n = GetParam();
	HalfEdgeMesh       m = halfEdgesOf(fan(n, 2 * pi, 0));
	HoleRetriangulator remover(m);
	ASSERT_TRUE(remover.remove(0, {0.9f, HUGE_VALF}));
	const TriangleMesh after = meshOf(m);
	EXPECT_TRUE(isSoundSurface(after));
	EXPECT_TRUE(isSoundTable(m));
	EXPECT_EQ(int(after.faceNum()), n - 2);
	EXPECT_NEAR(factsOf(after).area, 0.5 * n * std::sin(2 * pi / n), 1e-6);
}

TEST_P(Fans, LoseABorderVertex)
{
	const int          n = GetParam();
	HalfEdgeMesh       m = halfEdgesOf(fan(n, pi, 0));
	HoleRetriangulator remover(m);
	ASSERT_TRUE(remover.remove(0, {0.9f, HUGE_VALF}));
	const TriangleMesh after = meshOf(m);
	EXPECT_TRUE(isSoundSurface(after));
	EXPECT_TRUE(isSoundTable(m));
	EXPECT_EQ(int(after.faceNum()), n - 1);
	EXPECT_EQ(factsOf(after).borderEdges, n + 1);
}

INSTANTIATE_TEST_SUITE_P(Valence, Fans, ::testing::Range(3, 13));

///        2               Corner 3 is so near the centre 0 that the edge 2 - 4 would cut through
///      / | \             the dent: only the edge 1 - 3 can close the hole.
///     /  0  \            (1 below, 3 above the centre)
TEST(HoleRetriangulation, ClosesADentedRing)
{
	const TriangleMesh mesh{{{0, 0, 0}, {0, -2, 0}, {2, 0.5, 0}, {0, 0.1, 0}, {-2, 0.5, 0}},
							{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1}};
	HalfEdgeMesh       m = halfEdgesOf(mesh);
	HoleRetriangulator remover(m);
	ASSERT_TRUE(remover.remove(0, {0.9f, HUGE_VALF}));
	EXPECT_TRUE(m.areNeighbours(1, 3));
	EXPECT_FALSE(m.areNeighbours(2, 4));
	EXPECT_NEAR(factsOf(meshOf(m)).area, factsOf(mesh).area, 1e-6);
}

/// Three corners under a pyramid's tip lie on a circle, the fourth a little inside or outside: the
/// empty circle decides the diagonal.
TEST(HoleRetriangulation, ClosesAHoleByTheDelaunayDiagonal)
{
	for (const double shift : {-0.05, 0.05}) {
		const TriangleMesh mesh{
			{{0.1, 0.2, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1 + shift, 0}},
			{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1}};
		HalfEdgeMesh       m = halfEdgesOf(mesh);
		HoleRetriangulator remover(m);
		ASSERT_TRUE(remover.remove(0, {0.9f, HUGE_VALF}));
		// Moved inwards, 4 lies in the circle of 1, 2, 3: the edge 2 - 4 appears.
		EXPECT_EQ(m.areNeighbours(2, 4), shift > 0) << shift;
		EXPECT_EQ(m.areNeighbours(1, 3), shift < 0) << shift;
	}
}

TEST(HoleRetriangulation, RefusesLongEdgesAndFolds)
{
	HalfEdgeMesh       m = halfEdgesOf(fan(6, 2 * pi, 0));
	HoleRetriangulator remover(m);
	EXPECT_FALSE(remover.remove(0, {0.9f, 1.0f})) << "new edges are longer than 1";
	EXPECT_EQ(meshOf(m).faceNum(), 6u) << "nothing changed";
	EXPECT_TRUE(remover.remove(0, {0.9f, 9.0f}));

	// Ring points alternate between far up and far down: the patch cannot be flat.
	TriangleMesh steep = fan(6, 2 * pi, 0);
	for (int i = 1; i <= 6; ++i)
		steep.positions[i].z = i % 2 == 0 ? 5 : -5;
	HalfEdgeMesh       folded = halfEdgesOf(steep);
	HoleRetriangulator other(folded);
	EXPECT_FALSE(other.remove(0, {0.9f, HUGE_VALF}));
	EXPECT_TRUE(other.remove(0, {-2.0f, HUGE_VALF}));
	EXPECT_TRUE(isSoundTable(folded));
}

/// The Delaunay diagonal is an edge already, below: the other diagonal is taken.
TEST(HoleRetriangulation, TakesAnotherDiagonalWhereTheBestIsThereAlready)
{
	const TriangleMesh tent{{{1, 0, 0}, {0, 1.2, 0}, {-1, 0, 0}, {0, -1.2, 0}, {0, 0, 1}},
							{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 2, 3, 2, 0}};
	HalfEdgeMesh       m = halfEdgesOf(tent);
	ASSERT_TRUE(m.areNeighbours(0, 2));
	HoleRetriangulator remover(m);
	ASSERT_TRUE(remover.remove(4, {-2.0f, HUGE_VALF}));
	EXPECT_TRUE(m.areNeighbours(1, 3));
	EXPECT_TRUE(isSoundTable(m));
	EXPECT_EQ(meshOf(m).faceNum(), 4u);
	for (int v = 0; v < 4; ++v)
		EXPECT_FALSE(remover.remove(v, {-2.0f, HUGE_VALF})) << "a tetrahedron stays";
}

TEST(HoleRetriangulation, RefusesRingsWithTooManyPlaces)
{
	const int          most = HoleRetriangulator::maxPlaces;
	HalfEdgeMesh       m    = halfEdgesOf(fan(most + 1, 2 * pi, 0));
	HoleRetriangulator remover(m);
	EXPECT_FALSE(remover.remove(0, {-2.0f, HUGE_VALF}));
	HalfEdgeMesh       smaller = halfEdgesOf(fan(most, 2 * pi, 0));
	HoleRetriangulator other(smaller);
	EXPECT_TRUE(other.remove(0, {-2.0f, HUGE_VALF}));
}

/// Vertices at one place, degenerate faces: removals do no damage.
TEST(HoleRetriangulation, SurvivesStarsWithoutAngle)
{
	TriangleMesh mesh = icosphere(1);
	for (std::size_t v = 0; v < 12; ++v)
		mesh.positions[v] = mesh.positions[0];
	HalfEdgeMesh       m = halfEdgesOf(mesh);
	HoleRetriangulator remover(m);
	for (int v = 0; v < m.vertexNum; ++v)
		remover.remove(v, {-2.0f, HUGE_VALF});
	EXPECT_TRUE(isSoundTable(m));
	EXPECT_TRUE(hasSameTopology(meshOf(m), mesh));
}

} // namespace

} // namespace gpr::test
