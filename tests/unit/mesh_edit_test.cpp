// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/mesh_zoo.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// Whether the triangles alone, without their shapes, form a manifold.
::testing::AssertionResult isManifold(const HalfEdgeMesh& m)
{
	const SurfaceFacts facts = factsOf(meshOf(m));
	if (facts.isManifold()) return isSoundTable(m);
	return ::testing::AssertionFailure() << facts.complaints();
}

int edgeBetween(const HalfEdgeMesh& m, int a, int b)
{
	const int h = m.findHalfEdge(a, b);
	EXPECT_GE(h, 0) << "no edge " << a << " - " << b;
	return h;
}

/// The patch that joins every place of the ring to the place `from`.
HolePatch fanPatch(int placeNum, int from)
{
	HolePatch patch;
	for (int t = 0; t + 2 < placeNum; ++t) {
		const int a = (from + t + 1) % placeNum;
		patch.corner.insert(patch.corner.end(), {from, a, (a + 1) % placeNum});
		patch.across.insert(patch.across.end(), {3 * t - 1, -1 - a, 3 * t + 3});
	}
	if (placeNum > 2) {
		patch.across.front() = -1 - from;
		patch.across.back()  = -1 - (from + placeNum - 1) % placeNum;
	}
	return patch;
}

/// Removes a vertex by a fan, if allowed; returns whether.
bool removeByFan(HalfEdgeMesh& m, int v, int from, EditScratch& scratch)
{
	VertexStar star;
	collectStar(m, v, star);
	const HolePatch patch = fanPatch(star.placeNum(), from % star.placeNum());
	if (!canRemoveVertex(m, star, patch, scratch)) return false;
	removeVertex(m, star, patch, scratch);
	return true;
}

///   6---7---8      Collapsing the centre of a 2 × 2 grid into vertex 5 takes two faces away.
///   | \ | / |
///   3---4---5
///   | / | \ |
///   0---1---2
TEST(MeshEdit, CollapseMergesTheCentreIntoANeighbour)
{
	HalfEdgeMesh m = halfEdgesOf(grid(2, 2));
	EditScratch  scratch;
	int          into = -1;
	forEachOutgoing(m, 4, [&](int h) {
		if (canCollapse(m, h, scratch)) into = h;
	});
	ASSERT_GE(into, 0);
	collapse(m, into);
	EXPECT_TRUE(isManifold(m));
	EXPECT_EQ(meshOf(m).faceNum(), 6u);
	EXPECT_EQ(meshOf(m).vertexNum(), 8u);
	EXPECT_LT(m.outgoing[4], 0);
}

/// Nothing smaller than a tetrahedron is closed: none of its edges may go.
TEST(MeshEdit, ATetrahedronAllowsNoCollapseAndNoFlip)
{
	for (const ZooMesh& zoo : meshZoo()) {
		if (zoo.name != "tetrahedron" && zoo.name != "sevenVertexTorus") continue;
		const HalfEdgeMesh m = halfEdgesOf(zoo.mesh);
		EditScratch        scratch;
		for (int h = 0; h < m.halfEdgeNum(); ++h) {
			EXPECT_FALSE(canCollapse(m, h, scratch)) << zoo.name;
			EXPECT_FALSE(canFlip(m, h)) << zoo.name;
		}
	}
}

/// A neck of three edges: the collapse of one edge would close the neck.
TEST(MeshEdit, TheLinkConditionKeepsANeckOpen)
{
	const HalfEdgeMesh m = halfEdgesOf(torus(3, 8));
	EditScratch        scratch;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		const int a = m.origin[h], b = m.target(h);
		if (a / 3 == b / 3) {
			EXPECT_FALSE(canCollapse(m, h, scratch)) << a << " - " << b;
		}
	}
}

TEST(MeshEdit, CollapseNeverTakesABorderVertex)
{
	const HalfEdgeMesh m = halfEdgesOf(grid(3, 3));
	EditScratch        scratch;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (m.isBorderVertex(m.origin[h])) {
			EXPECT_FALSE(canCollapse(m, h, scratch));
		}
	}
}

///   3---2          3---2
///   |  /|    =>    |\  |
///   | / |          | \ |
///   0---1          0---1
TEST(MeshEdit, FlipTurnsTheDiagonalAndBackAgain)
{
	HalfEdgeMesh m =
		halfEdgesOf(subdivided({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3}}));
	const TriangleMesh before = meshOf(m);
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (!canFlip(m, h)) continue;
		const int a = m.origin[h], b = m.target(h), c = m.apex(h), d = m.apex(m.opposite[h]);
		flip(m, h);
		EXPECT_TRUE(isManifold(m));
		EXPECT_LT(m.findHalfEdge(a, b), 0);
		EXPECT_EQ(m.origin[h], a);
		EXPECT_EQ(m.target(h), d);
		EXPECT_EQ(m.apex(h), c);
		flip(m, edgeBetween(m, d, c));
		EXPECT_TRUE(isManifold(m));
		EXPECT_GE(m.findHalfEdge(a, b), 0);
	}
	EXPECT_EQ(factsOf(meshOf(m)).edges, factsOf(before).edges);
}

TEST(MeshEdit, SplitsAddOneVertexAndTwoFacesOrOneAtTheBorder)
{
	HalfEdgeMesh m = halfEdgesOf(grid(1, 1), 2, 3);
	m.vertexNum    = 5;
	m.position[4]  = {0.5f, 0.5f, 0};
	splitEdge(m, edgeBetween(m, 0, 3), 4);
	EXPECT_TRUE(isManifold(m));
	EXPECT_EQ(m.faceNum, 4);
	const int h   = m.outgoing[0];
	m.vertexNum   = 6;
	m.position[5] = (m.position[0] + m.position[m.target(h)]) * 0.5f;
	splitBorderEdge(m, h, 5);
	EXPECT_TRUE(isManifold(m));
	EXPECT_EQ(m.faceNum, 5);
	EXPECT_EQ(borderNeighbour(m, 5, false), 0);
	EXPECT_EQ(borderNeighbour(m, 0, true), 5);
}

TEST(MeshEdit, SplittingAFaceMakesThreeOfIt)
{
	const TriangleMesh mesh = grid(2, 2);
	for (int f = 0; f < int(mesh.faceNum()); ++f) {
		HalfEdgeMesh m = halfEdgesOf(mesh, 1, 2);
		m.position[9]  = (m.position[m.origin[3 * f]] + m.position[m.origin[3 * f + 1]] +
                         m.position[m.origin[3 * f + 2]]) *
						(1 / 3.0f);
		m.vertexNum = 10;
		splitFace(m, f, 9);
		EXPECT_TRUE(isManifold(m)) << "face " << f;
		EXPECT_EQ(m.faceNum, 10);
		EXPECT_EQ(m.valence(9), 3);
		EXPECT_NEAR(factsOf(meshOf(m)).area, 1, 1e-6);
	}
}

/// Round the centre of a 2 × 2 grid lie eight places; every fan of these places closes the hole.
TEST(MeshEdit, RemovingAVertexClosesItsHoleByThePatch)
{
	EditScratch scratch;
	for (int from = 0; from < 8; ++from) {
		HalfEdgeMesh m = halfEdgesOf(grid(2, 2));
		ASSERT_EQ(m.valence(4), 8);
		ASSERT_TRUE(removeByFan(m, 4, from, scratch));
		EXPECT_TRUE(isManifold(m));
		EXPECT_EQ(meshOf(m).faceNum(), 6u);
		EXPECT_LT(m.outgoing[4], 0);
		EXPECT_TRUE(hasSameTopology(meshOf(m), grid(2, 2)));
	}
}

///   6---7---8      Taking out vertex 1 makes 0 - 2 the border, taking out 0 makes 3 - 1.
///   | \ | / |
///   3---4---5
///   | / | \ |
///   0---1---2
TEST(MeshEdit, RemovingABorderVertexClosesTheHoleAlongTheBorder)
{
	EditScratch scratch;
	for (int v : {0, 1, 2, 3, 5, 6, 7, 8}) {
		HalfEdgeMesh m = halfEdgesOf(grid(2, 2));
		VertexStar   star;
		collectStar(m, v, star);
		ASSERT_FALSE(star.isClosed);
		ASSERT_EQ(star.placeNum(), int(star.spoke.size()) + 1);
		bool removed = false;
		for (int from = 0; from < star.placeNum() && !removed; ++from)
			removed = removeByFan(m, v, from, scratch);
		ASSERT_TRUE(removed) << v;
		EXPECT_TRUE(isManifold(m)) << v;
		EXPECT_EQ(meshOf(m).faceNum(), 7u) << v;
		EXPECT_EQ(factsOf(meshOf(m)).borderEdges, 7) << v;
		EXPECT_TRUE(m.isBorderVertex(star.ring.front()));
		EXPECT_EQ(borderNeighbour(m, star.ring.back(), true), star.ring.front());
	}
}

/// The top of an octahedron may go; then the bottom only if the other diagonal is taken.
TEST(MeshEdit, RemovalNeverDoublesAnEdge)
{
	const TriangleMesh octahedron{
		{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
		{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5}};
	HalfEdgeMesh m = halfEdgesOf(octahedron);
	EditScratch  scratch;
	ASSERT_TRUE(removeByFan(m, 4, 0, scratch));
	EXPECT_TRUE(isManifold(m));
	VertexStar star;
	collectStar(m, 5, star);
	int allowed = 0;
	for (int from = 0; from < 2; ++from)
		allowed += canRemoveVertex(m, star, fanPatch(4, from), scratch);
	EXPECT_EQ(allowed, 1);
	ASSERT_TRUE(removeByFan(m, 5, 0, scratch) || removeByFan(m, 5, 1, scratch));
	EXPECT_TRUE(isManifold(m));
	EXPECT_EQ(meshOf(m).faceNum(), 4u) << "a tetrahedron is left";
	for (int v = 0; v < 4; ++v)
		EXPECT_FALSE(removeByFan(m, v, 0, scratch)) << "nothing smaller is closed";
}

/// A single triangle is nothing but border; a loop of three keeps its vertices.
TEST(MeshEdit, RemovalKeepsTheLastFaceAndLoopsOfThree)
{
	EditScratch  scratch;
	HalfEdgeMesh triangle = halfEdgesOf({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}});
	for (int v = 0; v < 3; ++v)
		EXPECT_FALSE(removeByFan(triangle, v, 0, scratch));
	HalfEdgeMesh m = halfEdgesOf(grid(6, 6));
	for (bool again = true; again;) {
		again = false;
		for (int v = 0; v < m.vertexNum; ++v) {
			if (m.outgoing[v] < 0 || !m.isBorderVertex(v)) continue;
			for (int from = 0; from < 6 && m.outgoing[v] >= 0; ++from)
				again = removeByFan(m, v, from, scratch) || again;
		}
		ASSERT_TRUE(isManifold(m));
	}
	EXPECT_EQ(factsOf(meshOf(m)).borderEdges, 3);
}

TEST(MeshEdit, ALoopKeepsThreeVertices)
{
	HalfEdgeMesh m = halfEdgesOf(grid(6, 6));
	EditScratch  scratch;
	for (bool again = true; again;) {
		again = false;
		for (int v = 0; v < m.vertexNum; ++v) {
			if (m.outgoing[v] < 0 || !m.isBorderVertex(v)) continue;
			for (bool forward : {true, false}) {
				if (m.outgoing[v] < 0 || !canCollapseAlongBorder(m, v, forward, scratch)) continue;
				collapseAlongBorder(m, v, forward);
				again = true;
			}
		}
		ASSERT_TRUE(isManifold(m));
	}
	EXPECT_EQ(factsOf(meshOf(m)).borderEdges, 3);
}

TEST(MeshEdit, CompactDropsTheDeadAndKeepsTheOrder)
{
	HalfEdgeMesh m = halfEdgesOf(icosphere(2));
	EditScratch  scratch;
	for (int h = 0; h < m.halfEdgeNum(); h += 7) {
		if (m.origin[h] >= 0 && canCollapse(m, h, scratch)) collapse(m, h);
	}
	const TriangleMesh before = meshOf(m);
	const int          room   = m.vertexNum;
	Workers            workers(2, nullptr);
	Buffer<int>        newIndex;
	compact(m, workers, newIndex);
	ASSERT_EQ(int(newIndex.size()), room);
	EXPECT_TRUE(isManifold(m));
	EXPECT_EQ(m.vertexNum, int(before.vertexNum()));
	EXPECT_EQ(m.faceNum, int(before.faceNum()));
	EXPECT_EQ(meshOf(m).triangles, before.triangles);
	int last = -1;
	for (int n : newIndex) {
		if (n < 0) continue;
		EXPECT_EQ(n, last + 1);
		last = n;
	}
}

/// Random edits: whatever the tests allow keeps the mesh an oriented manifold of the same topology.
class RandomEdits : public ::testing::TestWithParam<std::uint32_t> {
protected:
	Random       random{GetParam()};
	HalfEdgeMesh m;
	EditScratch  scratch;
	int          done = 0;

	void editOnce()
	{
		const int h = random.below(m.halfEdgeNum());
		if (m.origin[h] < 0) return;
		switch (random.below(8)) {
		case 7:
			count(m.hasCreases() && canCollapseAlongCrease(m, h, scratch), [&] { collapse(m, h); });
			break;
		case 0:
			count(canCollapse(m, h, scratch), [&] { collapse(m, h); });
			break;
		case 1:
			count(canFlip(m, h), [&] { flip(m, h); });
			break;
		case 2:
			collapseBorder(m.origin[h], random.chance(0.5));
			break;
		case 3:
			if (m.opposite[h] >= 0) count(true, [&] { splitEdge(m, h, addVertex(h)); });
			break;
		case 4:
			done += removeByFan(m, m.origin[h], random.below(100), scratch);
			break;
		case 5:
			count(true, [&] {
				const Vec3f centre = m.faceCentre(h / 3);
				const int   v      = addVertex(h);
				if (m.mirrorAxis >= 0) m.position[v] = centre; // an inner vertex is off the plane
				splitFace(m, h / 3, v);
			});
			break;
		default:
			if (m.opposite[h] < 0) count(true, [&] { splitBorderEdge(m, h, addVertex(h)); });
			break;
		}
	}

	/// The number of coordinates by which the point is on a face of the unit cube.
	static int cubeFacesAt(const Vec3f& p)
	{
		int n = 0;
		for (float x : {p.x, p.y, p.z})
			n += std::min(std::abs(x), std::abs(x - 1)) < 1e-6f;
		return n;
	}

	void expectLinesOfACube() const
	{
		double sum     = 0;
		int    corners = 0;
		for (int h = 0; h < m.halfEdgeNum(); ++h) {
			if (m.origin[h] < 0) continue;
			ASSERT_EQ(m.crease[h], m.crease[m.opposite[h]]);
			if (!m.isCreaseEdge(h)) continue;
			const Vec3f a = m.position[m.origin[h]], b = m.position[m.target(h)];
			ASSERT_GE(cubeFacesAt((a + b) * 0.5f), 2);
			sum += 0.5 * double(length(b - a));
		}
		for (int v = 0; v < m.vertexNum; ++v)
			corners += m.outgoing[v] >= 0 && m.creaseNum(v) == 3;
		EXPECT_EQ(corners, 8);
		EXPECT_NEAR(sum, 12, 1e-4) << "every cube edge is covered once";
	}

private:
	template <class Edit>
	void count(bool allowed, const Edit& edit)
	{
		if (!allowed) return;
		edit();
		++done;
	}
	void collapseBorder(int v, bool forward)
	{
		if (!m.isBorderVertex(v)) return;
		count(canCollapseAlongBorder(m, v, forward, scratch),
			  [&] { collapseAlongBorder(m, v, forward); });
	}
	int addVertex(int h)
	{
		m.position[m.vertexNum] = (m.position[m.origin[h]] + m.position[m.target(h)]) * 0.5f;
		return m.vertexNum++;
	}
};

TEST_P(RandomEdits, KeepManifoldAndTopology)
{
	SCOPED_TRACE("seed " + std::to_string(GetParam()));
	constexpr int edits = 1500, checkEvery = 50;
	for (int round = 0; round < 3; ++round) {
		const TriangleMesh mesh = round == 0
									  ? meshZoo()[std::size_t(GetParam()) % 8].mesh
									  : withHoles(round == 1 ? torus(9, 7) : grid(9, 9), 2, random);
		m                       = halfEdgesOf(mesh, edits, 2 * edits);
		for (int i = 1; i <= edits; ++i) {
			editOnce();
			if (i % checkEvery != 0) continue;
			ASSERT_TRUE(isManifold(m)) << "after " << done << " edits";
			ASSERT_TRUE(hasSameTopology(meshOf(m), mesh)) << "after " << done << " edits";
		}
	}
	EXPECT_GT(done, 1000);
}

/// Feature lines along a cube's edges: both halves of an edge stay marked alike, lines run along
/// the cube's edges whatever is flipped, split and merged, and its corners stay.
TEST_P(RandomEdits, KeepFeatureLines)
{
	SCOPED_TRACE("seed " + std::to_string(GetParam()));
	constexpr int edits = 1500, checkEvery = 50;
	m = halfEdgesOf(cube(6), edits, 2 * edits);
	m.crease.reset(m.origin.size());
	m.crease.fill(0);
	for (int h = 0; h < m.halfEdgeNum(); ++h)
		m.crease[h] = dot(m.faceNormal(h / 3), m.faceNormal(m.opposite[h] / 3)) < 0.5f;
	for (int i = 1; i <= edits; ++i) {
		editOnce();
		if (i % checkEvery == 0) expectLinesOfACube();
	}
	EXPECT_GT(done, 300);
}

/// A mesh and its mirror image across x = 0, joined there.
TriangleMesh withImage(const TriangleMesh& half)
{
	TriangleMesh              both = half;
	std::vector<std::int32_t> image;
	for (std::size_t v = 0; v < half.vertexNum(); ++v) {
		const Vec3d p = half.positions[v];
		image.push_back(p.x == 0 ? std::int32_t(v) : std::int32_t(both.vertexNum()));
		if (p.x != 0) both.positions.push_back({-p.x, p.y, p.z});
	}
	for (std::size_t f = 0; f < half.faceNum(); ++f) {
		for (std::size_t k : {0, 2, 1})
			both.triangles.push_back(image[std::size_t(half.triangles[3 * f + k])]);
	}
	return both;
}

/// After flips, splits and collapses in half of a symmetric mesh, the half fits to its image.
TEST_P(RandomEdits, KeepHalvesThatFitToTheirImages)
{
	SCOPED_TRACE("seed " + std::to_string(GetParam()));
	constexpr int edits = 1500, checkEvery = 25;
	for (const TriangleMesh& mesh : {grid(9, 9), withHoles(grid(12, 9), 2, random)}) {
		const TriangleMesh whole = withImage(mesh);
		m                        = halfEdgesOf(mesh, edits, 2 * edits);
		m.mirrorAxis             = 0;
		for (int i = 1; i <= edits; ++i) {
			editOnce();
			if (i % checkEvery != 0) continue;
			const TriangleMesh both  = withImage(meshOf(m));
			const SurfaceFacts facts = factsOf(both);
			ASSERT_TRUE(facts.isManifold()) << facts.complaints() << "after " << done << " edits";
			ASSERT_TRUE(hasSameTopology(both, whole)) << "after " << done << " edits";
		}
	}
	EXPECT_GT(done, 600);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEdits, ::testing::ValuesIn(testSeeds(12)));

} // namespace

} // namespace gpr::test
