// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tests of the tests' tools: a blind audit would prove nothing.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/mesh_zoo.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr double pi = 3.14159265358979323846;

class Zoo : public ::testing::TestWithParam<ZooMesh> {};

TEST_P(Zoo, FactsAreThoseKnown)
{
	const ZooMesh&     zoo   = GetParam();
	const SurfaceFacts facts = factsOf(zoo.mesh);
	EXPECT_LE(zoo.mesh.vertexNum(), 12u);
	EXPECT_EQ(facts.isManifold(), zoo.isManifold) << facts.complaints();
	EXPECT_EQ(facts.components, zoo.components);
	EXPECT_EQ(facts.boundaryLoops, zoo.boundaryLoops);
	EXPECT_EQ(facts.euler(), zoo.euler);
	EXPECT_EQ(facts.unusedVertices, 0);
	EXPECT_EQ(facts.zeroAreaFaces, 0);
}

INSTANTIATE_TEST_SUITE_P(, Zoo, ::testing::ValuesIn(meshZoo()),
						 zooName<::testing::TestParamInfo<ZooMesh>>);

struct Shape {
	const char*  name;
	TriangleMesh mesh;
	int          components, boundaryLoops, euler;
	double       area;
};

TEST(MeshBuilders, MakeTheSurfacesTheyName)
{
	Random      random(1);
	const Shape shapes[] = {
		{"grid", grid(7, 5, 2, 3), 1, 1, 1, 6},
		{"jitteredGrid", jitteredGrid(9, 0.3, random), 1, 1, 1, 1},
		{"bentSheet", bentSheet(8, 1.2), 1, 1, 1, 1},
		{"twoSheets", twoSheets(6, 0.1), 2, 2, 2, 2},
		{"squareFrame", squareFrame(12, 4), 1, 2, 0, 8.0 / 9},
		{"openCylinder", openCylinder(64, 9, 1, 2), 1, 2, 0, 4 * pi},
		{"closedCylinder", closedCylinder(64, 9, 1, 2), 1, 0, 2, 6 * pi},
		{"cone", cone(64, 9, 3, 4), 1, 1, 1, 15 * pi},
		{"icosphere", icosphere(4), 1, 0, 2, 4 * pi},
		{"uvSphere", uvSphere(32, 64), 1, 0, 2, 4 * pi},
		{"torus", torus(96, 48), 1, 0, 0, 4 * pi * pi * 0.4},
		{"cube", cube(5), 1, 0, 2, 6},
		{"thinPlate", thinPlate(5, 0.01), 1, 0, 2, 2.04},
		{"holes", withHoles(grid(30, 30), 3, random), 1, 4, -2, 1},
	};
	for (const Shape& shape : shapes) {
		SCOPED_TRACE(shape.name);
		const SurfaceFacts facts = factsOf(shape.mesh);
		EXPECT_TRUE(isSoundSurface(shape.mesh));
		EXPECT_EQ(facts.components, shape.components);
		EXPECT_EQ(facts.boundaryLoops, shape.boundaryLoops);
		EXPECT_EQ(facts.euler(), shape.euler);
		EXPECT_NEAR(facts.area, shape.area, 0.02 * shape.area);
	}
}

/// Signed volume by the divergence theorem: positive when faces look outwards.
double volume(const TriangleMesh& mesh)
{
	double six = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const std::int32_t* t = &mesh.triangles[3 * f];
		six += dot(mesh.positions[t[0]], cross(mesh.positions[t[1]], mesh.positions[t[2]]));
	}
	return six / 6;
}

TEST(MeshBuilders, ClosedSurfacesLookOutwards)
{
	EXPECT_NEAR(volume(icosphere(4)), 4 * pi / 3, 0.02);
	EXPECT_NEAR(volume(uvSphere(32, 64)), 4 * pi / 3, 0.03);
	EXPECT_NEAR(volume(cube(3)), 1, 1e-12);
	EXPECT_NEAR(volume(closedCylinder(64, 3, 1, 2)), 2 * pi, 0.02);
	EXPECT_NEAR(volume(torus(96, 48)), 2 * pi * pi * 0.16, 0.02);
}

TEST(MeshBuilders, OneSidedSurfacesCannotBeOrientedAlike)
{
	EXPECT_GT(factsOf(moebiusStrip(20, 3)).againstEachOther, 0);
	EXPECT_EQ(factsOf(moebiusStrip(20, 3)).boundaryLoops, 1);
	EXPECT_GT(factsOf(kleinBottle(24, 12)).againstEachOther, 0);
	EXPECT_EQ(factsOf(kleinBottle(24, 12)).boundaryLoops, 0);
	EXPECT_EQ(factsOf(kleinBottle(24, 12)).euler(), 0);
}

TEST(MeshAudit, SeesEachKindOfDamage)
{
	const TriangleMesh good = icosphere(2);
	ASSERT_TRUE(isSoundSurface(good));
	TriangleMesh bad = good;
	std::swap(bad.triangles[0], bad.triangles[1]);
	EXPECT_EQ(factsOf(bad).againstEachOther, 3) << "one face turned over";
	bad = good;
	bad.triangles.insert(bad.triangles.end(), good.triangles.begin(), good.triangles.begin() + 3);
	EXPECT_EQ(factsOf(bad).duplicateFaces, 1);
	bad              = good;
	bad.triangles[5] = bad.triangles[4];
	EXPECT_EQ(factsOf(bad).repeatedCorners, 1);
	bad              = good;
	bad.triangles[7] = int(bad.vertexNum());
	EXPECT_EQ(factsOf(bad).indicesOutOfRange, 1);
	bad                = good;
	bad.positions[3].y = NAN;
	EXPECT_EQ(factsOf(bad).notFinite, 1);
	bad                             = good;
	bad.positions[bad.triangles[0]] = bad.positions[bad.triangles[1]];
	EXPECT_EQ(factsOf(bad).zeroAreaFaces, 2);
	bad = good;
	bad.positions.push_back({0, 0, 0});
	EXPECT_EQ(factsOf(bad).unusedVertices, 1);
	EXPECT_EQ(factsOf(fansSharingVertex(3)).brokenFans, 1);
	EXPECT_EQ(factsOf(finsOnEdge(4)).crowdedEdges, 1);
}

TEST(Oracles, AgreeWithTheClosedForms)
{
	EXPECT_DOUBLE_EQ(onSphere({2, 0, 0}, {0, 2, 0}), pi);
	EXPECT_NEAR(onCylinder({1, 0, 0}, {-1, 0, 4}, 1), std::hypot(pi, 4), 1e-12);
	EXPECT_DOUBLE_EQ(distanceToTriangle({0.2, 0.2, 3}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 3);
	EXPECT_DOUBLE_EQ(distanceToTriangle({-3, -4, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 5);
	EXPECT_NEAR(rimDistance(grid(5, 5), grid(9, 9)), 0, 1e-12);
	EXPECT_NEAR(rimDistance(grid(5, 5), shifted(grid(5, 5), {0, 0, 2})), 2, 1e-12);
	EXPECT_EQ(pairsNearerThan({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 1.5), 2);
}

TEST(Oracles, TheTableOfASoundMeshIsSound)
{
	Random       random(3);
	HalfEdgeMesh m = halfEdgesOf(withHoles(torus(20, 12), 2, random));
	EXPECT_TRUE(isSoundTable(m));
	m.opposite[10] = m.opposite[11];
	EXPECT_FALSE(isSoundTable(m));
}

} // namespace

} // namespace gpr::test
