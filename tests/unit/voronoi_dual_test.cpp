// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/retriangulation/voronoi_dual.h>
#include <vcg_extras/core/surface/nearest_samples.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

int openCellNum(const VoronoiDual& cells)
{
	std::set<int> open;
	for (std::size_t v = 0; v < cells.label.size(); ++v) {
		if (cells.surfaceVertex[v] >= 0) open.insert(cells.label[v]);
	}
	return int(open.size());
}

/// A surface without curves, and its cells.
class VoronoiCells : public ::testing::TestWithParam<std::uint32_t> {
protected:
	Random         random{GetParam()};
	Workers        workers{2, nullptr};
	BoundaryCurves noCurves;
	Surface        surface;
	Sampling       sampling;

	void takeSurface(const TriangleMesh& mesh) { surface = surfaceOf(mesh, workers); }

	/// Puts a sample at each vertex of the list, and makes the cells.
	void putSamples(const std::vector<int>& vertices)
	{
		sampling.radius = 0.1f;
		for (int v : vertices) {
			const int face = surface.mesh.outgoing[v] / 3;
			sampling.samples.push_back(
				{{surface.mesh.position[v], face}, surface.mesh.faceNormal(face), 1});
		}
		sampling.nearest = assignToSamples(surface, sampling.samples, workers);
	}

	void putRandomSamples(int num)
	{
		std::vector<int> vertices;
		while (int(vertices.size()) < num) {
			const int v = random.below(surface.mesh.vertexNum);
			if (std::find(vertices.begin(), vertices.end(), v) == vertices.end())
				vertices.push_back(v);
		}
		putSamples(vertices);
	}

	MeshFigures figures() { return figuresOf(surface.mesh, 1, workers); }
	VoronoiDual contract()
	{
		return makeVoronoiDual(surface, sampling, noCurves, figures(), workers);
	}
	ResultMesh remove() { return removeVertices(surface, sampling, noCurves, figures(), workers); }

	void expectSameTopology(const HalfEdgeMesh& mesh)
	{
		EXPECT_TRUE(isSoundTable(mesh));
		EXPECT_TRUE(factsOf(meshOf(mesh)).isManifold()) << factsOf(meshOf(mesh)).complaints();
		EXPECT_TRUE(hasSameTopology(meshOf(surface.mesh), meshOf(mesh)));
	}
};

TEST_P(VoronoiCells, OnASphereEveryOneBecomesAVertex)
{
	takeSurface(icosphere(5));
	sampling = sampleFront(surface, noCurves, cutIntoBlocks(surface, 1, workers), 0.06f, GetParam(),
						   workers);
	const VoronoiDual cells = contract();
	EXPECT_EQ(openCellNum(cells), 0);
	EXPECT_TRUE(cells.todo.empty());
	EXPECT_EQ(cells.mesh.vertexNum, int(sampling.samples.size()));
	for (std::size_t s = 0; s < sampling.samples.size(); ++s) {
		const int v = cells.sampleVertex[s];
		ASSERT_GE(v, 0);
		EXPECT_EQ(cells.mesh.position[v], sampling.samples[s].point.position);
	}
	expectSameTopology(cells.mesh);
}

TEST_P(VoronoiCells, TopologyStaysWhateverTheCells)
{
	takeSurface(random.below(2) == 0 ? torus(60, 30) : noisySphere(4, 0.1, random));
	putRandomSamples(8 + random.below(300));
	const ResultMesh result = remove();
	EXPECT_EQ(result.mesh.vertexNum, int(sampling.samples.size()) + int(result.leftoverNum));
	expectSameTopology(result.mesh);
}

TEST_P(VoronoiCells, VerticesThatWereCutOffGoToTheCellsRoundThem)
{
	takeSurface(icosphere(5));
	putRandomSamples(200);
	ASSERT_EQ(openCellNum(contract()), 0);
	for (int i = 0; i < 20; ++i)
		sampling.nearest[random.below(surface.mesh.vertexNum)] = {2, random.below(200)};
	const VoronoiDual cells = contract();
	EXPECT_LE(openCellNum(cells), 4);
	EXPECT_EQ(remove().mesh.vertexNum, 200);
	expectSameTopology(cells.mesh);
}

/// Four cells round a torus are rings, of Euler characteristic 0: contracted rings would cut the
/// torus.
TEST_P(VoronoiCells, RingsAreLeftOpen)
{
	takeSurface(torus(80, 24));
	putSamples({0, 1, 2, 3});
	for (int v = 0; v < surface.mesh.vertexNum; ++v) {
		const Vec3f  p      = surface.mesh.position[v];
		const double turn   = std::atan2(double(p.y), double(p.x)) / (2 * 3.14159265358979) + 0.5;
		sampling.nearest[v] = {1, std::min(3, int(turn * 4))};
	}
	EXPECT_EQ(openCellNum(contract()), 4);
	expectSameTopology(remove().mesh);
}

/// A cell with a handle has a single border loop, as a disk has, but is no disk.
TEST_P(VoronoiCells, ACellWithAHandleIsLeftOpen)
{
	takeSurface(torus(60, 30));
	putRandomSamples(60);
	const Vec3f far = sampling.samples[0].point.position;
	for (int v = 0; v < surface.mesh.vertexNum; ++v) {
		if (length(surface.mesh.position[v] - far) > 0.4f) sampling.nearest[v].sample = 1;
	}
	expectSameTopology(remove().mesh);
}

/// A disk and a whole torus have together the Euler characteristic of a disk; contracted, the torus
/// would be lost.
TEST_P(VoronoiCells, ACellWithAnotherComponentInItIsLeftOpen)
{
	takeSurface(joined(icosphere(5), shifted(torus(12, 8, 0.04, 0.01), {1.5, 0, 0})));
	const auto isOfTorus = [&](int v) {
		return surface.frame.toCaller(surface.mesh.position[v]).x > 1.2;
	};
	std::vector<int> ball;
	for (int v = 0; v < surface.mesh.vertexNum; ++v) {
		if (!isOfTorus(v)) ball.push_back(v);
	}
	random.shuffle(ball);
	putSamples({ball.begin(), ball.begin() + 200});
	for (int v = 0; v < surface.mesh.vertexNum; ++v) {
		if (isOfTorus(v)) sampling.nearest[v] = {1, 0};
	}
	expectSameTopology(contract().mesh);
}

TEST_P(VoronoiCells, AreTheSameForAnyNumberOfThreads)
{
	takeSurface(torus(60, 30));
	putRandomSamples(150);
	Workers           one(1, nullptr), three(3, nullptr);
	const VoronoiDual a = makeVoronoiDual(surface, sampling, noCurves, figures(), one);
	const VoronoiDual b = makeVoronoiDual(surface, sampling, noCurves, figures(), three);
	EXPECT_EQ(a.label, b.label);
	EXPECT_EQ(a.todo, b.todo);
	ASSERT_EQ(a.mesh.faceNum, b.mesh.faceNum);
	EXPECT_TRUE(std::equal(a.mesh.origin.begin(), a.mesh.origin.begin() + 3 * a.mesh.faceNum,
						   b.mesh.origin.begin()));
}

INSTANTIATE_TEST_SUITE_P(Seeds, VoronoiCells, ::testing::Range(1u, 7u));

} // namespace

} // namespace gpr::test
