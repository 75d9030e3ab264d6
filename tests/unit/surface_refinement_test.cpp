// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/split_edges.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/input/surface_refinement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// Sizes that fall to an eighth towards a side.
Buffer<float> sizesAlong(const Surface& s)
{
	Buffer<float> size(s.mesh.vertexNum);
	for (int v = 0; v < s.mesh.vertexNum; ++v)
		size[v] = std::clamp(0.5f + s.mesh.position[v].x / s.grid.cubeSize, 0.125f, 1.0f);
	return size;
}

float longestEdgeOf(const HalfEdgeMesh& m)
{
	float longest = 0;
	for (int h = 0; h < m.halfEdgeNum(); ++h)
		longest = std::max(longest, length(m.position[m.origin[h]] - m.position[m.target(h)]));
	return longest;
}

/// The places of a face's corners, from the smallest corner on.
using Places = std::array<std::array<float, 3>, 3>;

std::vector<Places> facesOf(const HalfEdgeMesh& m)
{
	std::vector<Places> faces;
	for (int f = 0; f < m.faceNum; ++f) {
		Places places;
		for (int k = 0; k < 3; ++k) {
			const Vec3f p = m.position[m.origin[3 * f + k]];
			places[k]     = {p.x, p.y, p.z};
		}
		std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
		faces.push_back(places);
	}
	std::sort(faces.begin(), faces.end());
	return faces;
}

template <class T>
std::vector<T> firstOf(const Buffer<T>& values, int num)
{
	return std::vector<T>(values.begin(), values.begin() + num);
}

class SurfaceRefinement : public ::testing::TestWithParam<std::uint32_t> {
protected:
	Workers            workers{2, nullptr};
	Random             random{GetParam()};
	const TriangleMesh mesh = randomSurface(random);

	Surface withSizes()
	{
		Surface s = surfaceOf(mesh, workers);
		s.size    = sizesAlong(s);
		return s;
	}

	/// Splits edges above a share of the longest edge; returns the number of splits.
	std::int64_t refine(Surface& s, float share)
	{
		const float longest = longestEdgeOf(s.mesh) * share;
		return refineSurface(findLongFaces(s, longest, workers), longest, 1 << 28, s, workers);
	}
};

/// Compared with the long way: splitting, ordering and connecting anew.
TEST_P(SurfaceRefinement, IsWhatSplittingAndConnectingAnewMakes)
{
	Surface     s = withSizes(), other = withSizes();
	const float longest = longestEdgeOf(s.mesh) * 0.9f;
	const auto  found   = findLongFaces(s, longest, workers);
	ASSERT_FALSE(found.empty());

	const std::int64_t splits  = refineSurface(found, longest, 1 << 28, s, workers);
	IndexedMesh        indexed = disconnect(other);
	EXPECT_EQ(splits, splitLongEdges(indexed, longest, 1 << 28, workers));
	other = surfaceOf(std::move(indexed), workers);

	EXPECT_TRUE(isSoundTable(s.mesh));
	EXPECT_EQ(s.mesh.vertexNum, other.mesh.vertexNum);
	EXPECT_EQ(facesOf(s.mesh), facesOf(other.mesh));
	EXPECT_TRUE(findLongFaces(s, longest, workers).empty());
}

/// Inserting takes a fraction of the time of ordering and connecting anew, and must show nowhere.
TEST_P(SurfaceRefinement, HasTheBytesOfOrderingAndConnectingAnew)
{
	Surface s = surfaceOf(mesh, workers), other = surfaceOf(mesh, workers);
	s.size     = Buffer<float>(s.mesh.vertexNum, 1.0f);
	other.size = Buffer<float>(s.mesh.vertexNum, 1.0f);

	const float longest = longestEdgeOf(s.mesh) * 0.95f;
	ASSERT_GT(refineSurface(findLongFaces(s, longest, workers), longest, 1 << 28, s, workers), 0);
	IndexedMesh indexed = disconnect(other);
	splitLongEdges(indexed, longest, 1 << 28, workers);
	other = surfaceOf(std::move(indexed), workers);
	if (other.grid.level != s.grid.level)
		GTEST_SKIP() << "With so many new vertices ordering anew takes smaller cells.";

	EXPECT_EQ(firstOf(s.mesh.position, s.mesh.vertexNum),
			  firstOf(other.mesh.position, other.mesh.vertexNum));
	EXPECT_EQ(firstOf(s.mesh.outgoing, s.mesh.vertexNum),
			  firstOf(other.mesh.outgoing, other.mesh.vertexNum));
	EXPECT_EQ(firstOf(s.mesh.origin, s.mesh.halfEdgeNum()),
			  firstOf(other.mesh.origin, other.mesh.halfEdgeNum()));
	EXPECT_EQ(firstOf(s.mesh.opposite, s.mesh.halfEdgeNum()),
			  firstOf(other.mesh.opposite, other.mesh.halfEdgeNum()));
	EXPECT_EQ(firstOf(s.sourceFace, s.mesh.faceNum), firstOf(other.sourceFace, other.mesh.faceNum));
	EXPECT_EQ(firstOf(s.size, s.mesh.vertexNum), firstOf(other.size, other.mesh.vertexNum));
}

TEST_P(SurfaceRefinement, KeepsVerticesInTheOrderOfTheCells)
{
	Surface s = withSizes();
	ASSERT_GT(refine(s, 0.5f), 0);
	for (int v = 1; v < s.mesh.vertexNum; ++v) {
		ASSERT_LE(s.grid.cell(s.mesh.position[v - 1], s.grid.level),
				  s.grid.cell(s.mesh.position[v], s.grid.level));
	}
}

/// The sampling looks for the faces of a block in a range of faces, and misses faces out of order.
TEST_P(SurfaceRefinement, KeepsFacesInTheOrderOfTheirSmallestVertex)
{
	Surface s = withSizes();
	ASSERT_GT(refine(s, 0.5f), 0);
	int before = 0;
	for (int f = 0; f < s.mesh.faceNum; ++f) {
		const int* corner = &s.mesh.origin[3 * f];
		ASSERT_LT(corner[0], corner[1]);
		ASSERT_LT(corner[0], corner[2]);
		ASSERT_GE(corner[0], before);
		before = corner[0];
	}
}

TEST_P(SurfaceRefinement, TellsNormalsAreasSizesAndSources)
{
	Surface s = withSizes();
	refine(s, 0.7f);
	for (int v = 0; v < s.mesh.vertexNum; ++v) {
		const PackedNormal normal = s.normal[v];
		const float        ofRing = s.area[v].value();
		measureVertex(v, s);
		ASSERT_EQ(length(s.normal[v].unpack() - normal.unpack()), 0);
		ASSERT_EQ(s.normal[v].isRough(), normal.isRough());
		ASSERT_EQ(s.area[v].value(), ofRing);
		ASSERT_GE(s.size[v], 0.125f);
		ASSERT_LE(s.size[v], 1);
	}
	std::vector<double> area(mesh.faceNum(), 0);
	const double        unit = 0.5 / double(s.frame.scale) / double(s.frame.scale);
	for (int f = 0; f < s.mesh.faceNum; ++f)
		area.at(s.sourceFace[f]) += unit * double(length(s.mesh.faceCross(f)));
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		TriangleMesh one;
		one.positions = mesh.positions;
		one.triangles = {mesh.triangles[3 * f], mesh.triangles[3 * f + 1],
						 mesh.triangles[3 * f + 2]};
		ASSERT_NEAR(area[f], factsOf(one).area, 1e-4 * factsOf(one).area + 1e-9);
	}
}

INSTANTIATE_TEST_SUITE_P(, SurfaceRefinement, ::testing::Range(1u, 13u));

TEST(SurfaceRefinementOf, ShortEdgesNothingChanges)
{
	Workers   workers(1, nullptr);
	Surface   s      = surfaceOf(icosphere(2), workers);
	const int before = s.mesh.faceNum;
	EXPECT_EQ(refineSurface({}, 1, 1 << 28, s, workers), 0);
	EXPECT_EQ(s.mesh.faceNum, before);
	EXPECT_TRUE(isSoundTable(s.mesh));
}

TEST(SurfaceRefinementOf, TooManyFacesAreRefused)
{
	Workers workers(1, nullptr);
	Surface s = surfaceOf(icosphere(2), workers);
	try {
		refineSurface(findLongFaces(s, 1e-5f, workers), 1e-5f, 100000, s, workers);
		FAIL() << "accepted";
	}
	catch (const Failure& f) {
		EXPECT_EQ(f.status, Status::OutOfMemory);
	}
}

} // namespace

} // namespace gpr::test
