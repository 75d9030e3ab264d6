// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/mesh_zoo.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// Orders and connects a mesh; the members have the mesh after each step.
struct Connected {
	Workers      workers{2, nullptr};
	IndexedMesh  indexed;
	TriangleMesh ordered;
	Surface      surface;
	bool         ok = false;

	explicit Connected(const TriangleMesh& mesh)
	{
		indexed = loaded(mesh, workers);
		Buffer<int> faceStart;
		surface.grid = orderSpatially(indexed, workers, faceStart);
		ordered      = meshOf(indexed);
		ok           = connect(indexed, faceStart, workers, surface);
	}
};

class ConnectZoo : public ::testing::TestWithParam<ZooMesh> {};

TEST_P(ConnectZoo, TakesManifoldsOnly)
{
	Connected c(GetParam().mesh);
	EXPECT_EQ(c.ok, GetParam().isManifold);
	if (c.ok) {
		EXPECT_TRUE(isSoundTable(c.surface.mesh));
	}
	else {
		EXPECT_EQ(meshOf(c.indexed).triangles, c.ordered.triangles)
			<< "left as it was, for the repair";
		EXPECT_TRUE(meshOf(c.indexed).positions == c.ordered.positions);
	}
}

INSTANTIATE_TEST_SUITE_P(, ConnectZoo, ::testing::ValuesIn(meshZoo()),
						 zooName<::testing::TestParamInfo<ZooMesh>>);

class Connect : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(Connect, OppositesAreThoseFoundByComparingAllEdges)
{
	Random random(GetParam());
	for (int round = 0; round < 4; ++round) {
		Connected c(randomSurface(random));
		ASSERT_TRUE(c.ok);
		EXPECT_TRUE(isSoundTable(c.surface.mesh));
		EXPECT_EQ(meshOf(c.surface.mesh).faceNum(), c.ordered.faceNum());
		const HalfEdgeMesh& m = c.surface.mesh;
		for (int h = 0; h < m.halfEdgeNum(); ++h)
			ASSERT_EQ(m.origin[h], c.ordered.triangles[h]);
	}
}

TEST_P(Connect, DamageIsNoticed)
{
	Random random(GetParam());
	for (int round = 0; round < 20; ++round) {
		const TriangleMesh mesh  = damaged(icosphere(1), 1 + random.below(3), random);
		const SurfaceFacts facts = factsOf(mesh);
		if (facts.repeatedCorners > 0) continue; // loading drops such faces
		EXPECT_EQ(Connected(mesh).ok, facts.isManifold()) << facts.complaints();
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, Connect, ::testing::ValuesIn(testSeeds(6)));

/// At such an edge each half-edge finds one in the opposite direction.
TEST(Connect, FourFacesAtAnEdgeAreNoManifold)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
	mesh.triangles = {0, 1, 2, 0, 1, 3, 1, 0, 4, 1, 0, 5};
	EXPECT_FALSE(Connected(mesh).ok);
}

TEST(ConnectAreas, AreAThirdOfTheFacesAtAVertex)
{
	Workers            workers(2, nullptr);
	const Surface      s = surfaceOf(grid(5, 3), workers);
	std::vector<float> area(std::size_t(s.mesh.vertexNum), 0);
	for (int h = 0; h < s.mesh.halfEdgeNum(); ++h)
		area[std::size_t(s.mesh.origin[h])] += length(s.mesh.faceCross(h / 3)) / 6;
	for (int v = 0; v < s.mesh.vertexNum; ++v)
		EXPECT_NEAR(s.area[v].value() / area[std::size_t(v)], 1, 0.003) << v;
}

TEST(ConnectNormals, AreTheSpheres)
{
	Workers       workers(2, nullptr);
	const Surface s = surfaceOf(icosphere(3), workers);
	for (int v = 0; v < s.mesh.vertexNum; ++v) {
		const Vec3f outward = normalized(s.mesh.position[v]);
		EXPECT_GT(dot(normalized(s.normal[v].unpack()), outward), std::cos(0.02f));
	}
}

TEST(ConnectNormals, OfPointedVerticesAreMarked)
{
	// At 45° the tip lacks 105°, nearly flat nothing to speak of.
	for (double height : {std::sqrt(3.0), 0.01}) {
		Connected c(cone(24, 12, std::sqrt(3.0), height));
		ASSERT_TRUE(c.ok);
		int marked = 0;
		for (int v = 0; v < c.surface.mesh.vertexNum; ++v) {
			if (!c.surface.normal[v].isPointed()) continue;
			++marked;
			EXPECT_FALSE(c.surface.mesh.isBorderVertex(v));
		}
		EXPECT_EQ(marked, height > 0.5 ? 1 : 0);
	}
}

TEST(HalfEdgeMesh, TurnsRoundAVertexSeeEveryNeighbourOnce)
{
	const HalfEdgeMesh m = halfEdgesOf(grid(4, 4));
	for (int v = 0; v < m.vertexNum; ++v) {
		std::vector<int> ring;
		int              corners = 0;
		forEachNeighbour(m, v, [&](int w) { ring.push_back(w); });
		forEachOutgoing(m, v, [&](int h) { corners += m.origin[h] == v; });
		EXPECT_EQ(corners, m.valence(v));
		EXPECT_EQ(int(ring.size()), m.valence(v) + m.isBorderVertex(v));
		std::sort(ring.begin(), ring.end());
		EXPECT_EQ(std::unique(ring.begin(), ring.end()), ring.end());
		for (int w = 0; w < m.vertexNum; ++w) {
			const bool near = std::binary_search(ring.begin(), ring.end(), w);
			EXPECT_EQ(m.areNeighbours(v, w), near);
			const int h = m.findHalfEdge(v, w);
			if (h >= 0) {
				EXPECT_TRUE(m.origin[h] == v && m.target(h) == w);
			}
			EXPECT_EQ(near, h >= 0 || m.findHalfEdge(w, v) >= 0);
		}
		if (m.isBorderVertex(v)) {
			EXPECT_EQ(m.target(m.incomingBorder(v)), v);
			EXPECT_TRUE(m.isBorderEdge(m.incomingBorder(v)));
			EXPECT_TRUE(m.isBorderEdge(m.outgoing[v]));
		}
	}
}

/// The places of the rough vertices of a mesh, in working units.
std::vector<Vec3f> roughPlaces(const TriangleMesh& mesh)
{
	const Connected    c(mesh);
	std::vector<Vec3f> places;
	for (int v = 0; v < c.surface.mesh.vertexNum; ++v) {
		if (c.surface.normal[v].isRough()) places.push_back(c.surface.mesh.position[v]);
	}
	return places;
}

TEST(ConnectNormals, AtSharpEdgesAreMarked)
{
	// On a cube the vertices of edges are rough: eight corners and three vertices on each of twelve
	// edges.
	const std::vector<Vec3f> places = roughPlaces(cube(4));
	EXPECT_EQ(int(places.size()), 8 + 12 * 3);
	EXPECT_TRUE(roughPlaces(icosphere(4)).empty());
}

TEST(ConnectNormals, OfThinFacesAreMarkedAtAllCorners)
{
	TriangleMesh mesh = grid(2, 2);
	EXPECT_TRUE(roughPlaces(mesh).empty());
	// A second face on a border edge, with the third corner on the line of the edge.
	const int a = 0, b = 1; // two corners in a row along the lower border
	mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5);
	mesh.triangles.insert(mesh.triangles.end(), {b, a, int(mesh.vertexNum()) - 1});
	EXPECT_EQ(int(roughPlaces(mesh).size()), 3);
}

TEST(PackedNormal, MarksLeaveItAsItIs)
{
	const Vec3f  n = normalized(Vec3f(1, -2, 3));
	PackedNormal packed(n);
	EXPECT_FALSE(packed.isPointed() || packed.isRough());
	const Vec3f before = packed.unpack();
	packed.markPointed();
	EXPECT_TRUE(packed.isPointed() && !packed.isRough());
	packed.markRough();
	EXPECT_TRUE(packed.isPointed() && packed.isRough());
	EXPECT_EQ(packed.unpack(), before);
}

TEST(PackedNormal, IsTrueToATenthOfADegree)
{
	Random random(4);
	for (int i = 0; i < 1000; ++i) {
		const Vec3f n = normalized(
			Vec3f(Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1))));
		EXPECT_LT(length(normalized(PackedNormal(n).unpack()) - n), 0.0035f);
	}
}

} // namespace

} // namespace gpr::test
