// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/input/flat_pieces.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

class FlatPieces : public ::testing::Test {
protected:
	Workers workers{2, nullptr};

	/// The caller's faces found to be flat.
	std::vector<int> flatFaces(const TriangleMesh& mesh)
	{
		const Surface    surface = surfaceOf(mesh, workers);
		std::vector<int> faces   = findFlatPieces(surface, workers);
		for (int& f : faces)
			f = surface.sourceFace[f];
		std::sort(faces.begin(), faces.end());
		return faces;
	}
};

int addPoint(TriangleMesh& mesh, double x, double y, double z)
{
	mesh.positions.push_back({x, y, z});
	return int(mesh.vertexNum()) - 1;
}

void addTriangle(TriangleMesh& mesh, int a, int b, int c)
{
	mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

/// A square of two faces with the edge 0-1 along x.
TriangleMesh square()
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
	mesh.triangles = {0, 1, 2, 0, 2, 3};
	return mesh;
}

TEST_F(FlatPieces, SoundSurfacesHaveNone)
{
	for (std::uint32_t seed : testSeeds(20)) {
		Random random(seed);
		EXPECT_TRUE(flatFaces(randomSurface(random)).empty()) << seed;
	}
}

TEST_F(FlatPieces, AreComponentsThatAreLines)
{
	TriangleMesh mesh = square();
	const int    a = addPoint(mesh, 2, 0, 0), b = addPoint(mesh, 2, 0.5, 0);
	const int    c = addPoint(mesh, 2, 1, 0), d = addPoint(mesh, 2, 0.7, 1e-8);
	addTriangle(mesh, a, b, c);
	addTriangle(mesh, c, b, d);
	EXPECT_EQ(flatFaces(mesh), (std::vector<int>{2, 3}));
}

TEST_F(FlatPieces, AreNotNarrowOrTinyComponents)
{
	TriangleMesh mesh = joined(square(), shifted(icosphere(1, 1e-6), {2, 0, 0}));
	const int    a = addPoint(mesh, 1.5, 0, 0), b = addPoint(mesh, 1.5 + 1e-4, 0.5, 0);
	addTriangle(mesh, a, b, addPoint(mesh, 1.5, 1, 0));
	EXPECT_TRUE(flatFaces(mesh).empty());
}

TEST_F(FlatPieces, HangOnABorder)
{
	TriangleMesh mesh = square();
	const int    a = addPoint(mesh, 1.5, 0, 0), b = addPoint(mesh, 2, 0, 0);
	addTriangle(mesh, 1, 0, a);
	addTriangle(mesh, 1, a, b);
	EXPECT_EQ(flatFaces(mesh), (std::vector<int>{2, 3})) << "the second makes way for the first";
}

TEST_F(FlatPieces, LieAlongABorder)
{
	TriangleMesh mesh = square();
	const int    a    = addPoint(mesh, 0.5, 0, 0);
	mesh.triangles    = {0, a, 2, a, 1, 2, 0, 2, 3, 0, 1, a};
	EXPECT_EQ(flatFaces(mesh), (std::vector<int>{3}));
}

TEST_F(FlatPieces, AreNotWhatHoldsASurfaceTogether)
{
	TriangleMesh mesh = square();
	const int    a    = addPoint(mesh, 0.5, 0, 0);
	const int    b    = addPoint(mesh, 0.5, -1, 0);
	mesh.triangles    = {0, a, 2, a, 1, 2, 0, 2, 3, 0, 1, a, 0, b, 1};
	EXPECT_TRUE(flatFaces(mesh).empty()) << "inside";
}

TEST_F(FlatPieces, GoWithTheVerticesOnlyTheyHave)
{
	TriangleMesh mesh    = square();
	const int    a       = addPoint(mesh, 1.5, 0, 0);
	Surface      surface = [&] {
        addTriangle(mesh, 1, 0, a);
        return surfaceOf(mesh, workers);
	}();
	std::int64_t      dropped = 0;
	const auto        flat    = findFlatPieces(surface, workers);
	const IndexedMesh left    = withoutFaces(surface, flat, workers, dropped);
	EXPECT_EQ(left.vertexNum, 4);
	EXPECT_EQ(left.faceNum, 2);
	EXPECT_EQ(dropped, 1);
	EXPECT_TRUE(isSoundSurface(meshOf(left)));
}

TEST_F(FlatPieces, AreTheWholeOfNoSurface)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 1e-8}, {2, 0, 0}};
	mesh.triangles = {0, 1, 2};
	EXPECT_EQ(detectFeatures(mesh.view(), RemeshOptions()).status, Status::UnusableInput);
	EXPECT_EQ(remesh(mesh.view(), RemeshOptions()).status, Status::UnusableInput);
}

/// A strip of many faces, a hundred-millionth as wide as long: splitting its edges, as wide as they
/// should be for its area, would take all memory.
TEST_F(FlatPieces, AStripThatIsALineIsNoSurface)
{
	const TriangleMesh strip = rotated(grid(200, 2, 1, 1e-8), {1, 2, 3}, 1);
	for (const double percent : {10.0, 200.0}) {
		RemeshOptions options;
		options.targetPercent = percent;
		const RemeshResult r  = remesh(strip.view(), options);
		EXPECT_EQ(r.status, Status::UnusableInput) << r.message;
		EXPECT_EQ(samplePoissonDisks(strip.view(), options).status, Status::UnusableInput);
	}
}

TEST_F(FlatPieces, ANarrowStripIsASurface)
{
	const RemeshResult r = remesh(grid(200, 2, 1, 1e-4).view(), RemeshOptions());
	EXPECT_EQ(r.status, Status::Ok) << r.message;
}

/// Each face is thinner than the least width, but together the faces are a surface.
TEST_F(FlatPieces, NeedlesThatCoverASurfaceStay)
{
	const TriangleMesh needles = grid(1, 2000, 1, 1e-3);
	EXPECT_TRUE(allFacesThin(loaded(needles, workers), workers));
	EXPECT_LT(flatFaces(needles).size(), 20u) << "each borders on the next that is gone";
	EXPECT_FALSE(allFacesThin(loaded(joined(needles, square()), workers), workers));
	RemeshOptions options; // few triangles, as wide as the strip
	options.targetPercent = 0.3;
	const RemeshResult r  = remesh(needles.view(), options);
	EXPECT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_NEAR(r.report.cleanedInput.area, 1e-3, 1e-5);
	EXPECT_GT(factsOf(r.mesh).area, 0.5e-3);
}

} // namespace

} // namespace gpr::test
