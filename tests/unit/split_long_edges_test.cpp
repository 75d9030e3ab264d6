// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/split_edges.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/base/failure.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

double longestEdge(const TriangleMesh& mesh)
{
	double most = 0;
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
		most                   = std::max(
							  most, length(mesh.positions[mesh.triangles[next]] - mesh.positions[mesh.triangles[i]]));
	}
	return most;
}

class SplitLongEdges : public ::testing::TestWithParam<std::uint32_t> {
protected:
	Workers workers{2, nullptr};
};

TEST_P(SplitLongEdges, NoneIsLongerAndTheSurfaceStaysWhereItIs)
{
	Random random(GetParam());
	SCOPED_TRACE("seed " + std::to_string(GetParam()));
	for (int round = 0; round < 4; ++round) {
		IndexedMesh        m      = loaded(randomSurface(random), workers);
		const TriangleMesh before = meshOf(m);
		const float        limit  = float(longestEdge(before) * random.between(0.05, 1.1));
		const std::int64_t splits = splitLongEdges(m, limit, 1 << 28, workers);
		const TriangleMesh after  = meshOf(m);

		EXPECT_LE(longestEdge(after), limit * 1.000001);
		EXPECT_EQ(splits, std::int64_t(after.vertexNum() - before.vertexNum()));
		EXPECT_EQ(splits > 0, longestEdge(before) > limit);
		EXPECT_TRUE(isSoundSurface(after))
			<< "conforming: no vertex may lie on an edge of a neighbour";
		EXPECT_TRUE(hasSameTopology(before, after));
		EXPECT_NEAR(factsOf(after).area, factsOf(before).area, 1e-5 * factsOf(before).area);
		for (int f = 0; f < m.faceNum; ++f) {
			const std::int32_t* t = &before.triangles[3 * m.sourceFace[f]];
			Vec3d               centre;
			for (int k = 0; k < 3; ++k)
				centre += after.positions[after.triangles[3 * f + k]] * (1.0 / 3);
			ASSERT_LT(distanceToTriangle(centre, before.positions[t[0]], before.positions[t[1]],
										 before.positions[t[2]]),
					  1e-5)
				<< "sourceFace names the face that a piece lies in";
		}
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, SplitLongEdges, ::testing::ValuesIn(testSeeds(8)));

TEST(SplitLongEdgesOf, ShortEdgesNothingChanges)
{
	Workers            workers(1, nullptr);
	IndexedMesh        m      = loaded(icosphere(3), workers);
	const TriangleMesh before = meshOf(m);
	EXPECT_EQ(splitLongEdges(m, 10, 1000000, workers), 0);
	EXPECT_EQ(meshOf(m).triangles, before.triangles);
}

/// The search skips groups of faces without a long edge, and finds long edges in any group.
TEST(SplitLongEdgesOf, LongFacesAreFoundInEveryGroup)
{
	Workers           workers(2, nullptr);
	const IndexedMesh m = loaded(joined(icosphere(5), scaled(icosphere(2), 0.9)), workers);
	ASSERT_GT(m.faceNum, int(3 * Workers::pieceSize));
	for (float most : {0.01f, 0.03f, 0.1f, 1.0f}) {
		std::vector<int> expected;
		for (int f = 0; f < m.faceNum; ++f) {
			float longest = 0;
			for (int k = 0; k < 3; ++k) {
				const Vec3f a = m.position[m.triangle[3 * f + k]];
				longest =
					std::max(longest, length(m.position[m.triangle[3 * f + (k + 1) % 3]] - a));
			}
			if (longest > most) expected.push_back(f);
		}
		EXPECT_EQ(findLongFaces(m, measureFaces(m, workers), most, workers), expected) << most;
	}
}

TEST(SplitLongEdgesOf, ALongFaceIsFoundAtTheVeryEnd)
{
	Workers      workers(2, nullptr);
	TriangleMesh mesh = icosphere(3);
	ASSERT_NE((mesh.faceNum() + 1) % FaceExtents::facesTogether, 0u);
	const int n = int(mesh.vertexNum());
	mesh.positions.insert(mesh.positions.end(), {{0, 0, 3}, {2, 0, 3}, {0, 2, 3}});
	mesh.triangles.insert(mesh.triangles.end(), {n, n + 1, n + 2});
	const IndexedMesh m = loaded(mesh, workers);
	EXPECT_EQ(findLongFaces(m, measureFaces(m, workers), 0.2f, workers),
			  std::vector<int>{m.faceNum - 1});
}

/// An edge is too long for the smaller size of its ends. After the sizes are raised no edge is, and
/// no other size has changed.
TEST(SplitLongEdgesOf, FacesAreLongForTheirSizes)
{
	Workers       workers(2, nullptr);
	Surface       s    = surfaceOf(icosphere(4), workers);
	const float   edge = s.mesh.edgeLength(0);
	Buffer<float> size(s.mesh.vertexNum);
	for (int v = 0; v < s.mesh.vertexNum; ++v)
		size[v] = std::clamp(1.5f * s.mesh.position[v].x / s.grid.cubeSize, 0.25f, 1.0f);
	for (const float longest : {edge, 2 * edge, 4 * edge, 8 * edge}) {
		s.size.reset(size.size());
		std::copy(size.begin(), size.end(), s.size.begin());
		std::vector<int>  faces;
		std::vector<char> isCorner(size.size(), 0);
		for (int h = 0; h < s.mesh.halfEdgeNum(); ++h) {
			const int a = s.mesh.origin[h], b = s.mesh.target(h);
			if (!(s.mesh.edgeLength(h) > longest * std::min(size[a], size[b]))) continue;
			if (faces.empty() || faces.back() != h / 3) faces.push_back(h / 3);
			isCorner[a] = isCorner[b] = 1;
		}
		const LongFaces found = findTooLong(s, longest, workers);
		EXPECT_EQ(found.faces, faces);
		raiseSizes(found, s);
		EXPECT_TRUE(findTooLong(s, 1.0001f * longest, workers).faces.empty());
		for (std::size_t v = 0; v < size.size(); ++v) {
			EXPECT_GE(s.size[v], size[v]);
			if (!isCorner[v]) {
				EXPECT_EQ(s.size[v], size[v]);
			}
		}
	}
}

/// A huge face beside small faces, like a stray triangle of a scan: only the huge face is split.
TEST(SplitLongEdgesOf, AStrayTriangleIsDividedAndTheRestLeftAlone)
{
	Workers      workers(1, nullptr);
	TriangleMesh mesh = joined(icosphere(3, 0.1), {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {0, 1, 2}});
	IndexedMesh  m    = loaded(mesh, workers);
	const int    old  = m.faceNum;
	splitLongEdges(m, float(0.1 * m.frame.scale), 1000000, workers);
	int fromStray = 0;
	for (int f = 0; f < m.faceNum; ++f)
		fromStray += m.sourceFace[f] == old - 1;
	EXPECT_EQ(m.faceNum - fromStray, old - 1);
	EXPECT_EQ(fromStray, 4096) << "six halvings of all edges: 5.66 to 0.088";
}

/// A tetrahedron with three faces 200 times longer than wide, from which halving of all edges would
/// make 3⁸, and a sphere drawn out so much that most faces have only long edges.
TriangleMesh needles()
{
	TriangleMesh needle;
	needle.positions       = {{0, 0, 0}, {0, 1, 0}, {200, 0.5, 0}, {0, 0.5, 1}};
	needle.triangles       = {0, 1, 2, 1, 0, 3, 1, 3, 2, 3, 0, 2};
	TriangleMesh stretched = shifted(icosphere(2), {0, 0, 5});
	for (Vec3d& p : stretched.positions)
		p.x *= 100;
	return joined(needle, stretched);
}

TEST(SplitLongEdgesOf, NeedlesBecomeStrips)
{
	Workers            workers(1, nullptr);
	IndexedMesh        m      = loaded(needles(), workers);
	const TriangleMesh before = meshOf(m);
	const float        limit  = float(longestEdge(before) / 200);
	splitLongEdges(m, limit, 1 << 28, workers);
	const TriangleMesh after = meshOf(m);
	EXPECT_LE(longestEdge(after), limit * 1.000001);
	EXPECT_TRUE(isSoundSurface(after));
	EXPECT_TRUE(hasSameTopology(before, after));
	EXPECT_NEAR(factsOf(after).area, factsOf(before).area, 1e-5 * factsOf(before).area);
	EXPECT_LT(m.faceNum, 40000) << "halving made 167,830";
}

/// Vertices have different sizes, and an edge may be split deeper on the way to a small size.
TEST(SplitLongEdgesOf, NeedlesBecomeStripsWhereSizesDiffer)
{
	Workers            workers(1, nullptr);
	IndexedMesh        m      = loaded(needles(), workers);
	const TriangleMesh before = meshOf(m);
	Buffer<float>      size(m.vertexNum);
	for (int v = 0; v < m.vertexNum; ++v)
		size[v] = 1.0f / float(1 + v % 3);
	m.size = std::move(size);
	splitLongEdges(m, float(longestEdge(before) / 100), 1 << 28, workers);
	EXPECT_TRUE(isSoundSurface(meshOf(m)));
	EXPECT_TRUE(hasSameTopology(before, meshOf(m)));
	EXPECT_LT(m.faceNum, 100000);
}

TEST(SplitLongEdgesOf, ANeedleOfTooManyPartsIsRefusedBeforeTheyAreMade)
{
	Workers      workers(1, nullptr);
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1e-6, 0}};
	mesh.triangles = {0, 1, 2};
	IndexedMesh m  = loaded(mesh, workers);
	try {
		splitLongEdges(m, 1e-7f, 100000, workers);
		FAIL() << "accepted";
	}
	catch (const Failure& f) {
		EXPECT_EQ(f.status, Status::OutOfMemory);
	}
}

TEST(SplitLongEdgesOf, TooManyFacesAreRefusedWithoutHanging)
{
	Workers     workers(1, nullptr);
	IndexedMesh m = loaded(grid(2, 2), workers);
	try {
		splitLongEdges(m, 1e-4f, 10000, workers);
		FAIL() << "accepted";
	}
	catch (const Failure& f) {
		EXPECT_EQ(f.status, Status::OutOfMemory);
	}
}

} // namespace

} // namespace gpr::test
