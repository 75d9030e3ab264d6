// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/split_edges.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/features/feature_region.h>
#include <vcg_extras/core/mesh/spatial_order.h>

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

class FeatureRegionTest : public ::testing::Test {
protected:
	Workers                   workers{2, nullptr};
	TriangleMesh              mesh = grid(10, 10);
	std::vector<std::uint8_t> marks;

	/// Marks the vertices for which a condition on x and y holds.
	template <class Condition>
	void mark(const Condition& condition)
	{
		marks.clear();
		for (const Vec3d& p : mesh.positions)
			marks.push_back(condition(p.x, p.y));
	}
	/// The surface after splits of all edges longer than `longest`.
	Surface splitSurface(double longest)
	{
		IndexedMesh indexed = loaded(mesh, workers);
		splitLongEdges(indexed, float(longest * indexed.frame.scale), 1000000, workers);
		Surface     surface;
		Buffer<int> faceStart;
		surface.frame = indexed.frame;
		surface.grid  = orderSpatially(indexed, workers, faceStart);
		EXPECT_TRUE(connect(indexed, faceStart, workers, surface));
		return surface;
	}
};

TEST_F(FeatureRegionTest, NothingMarkedIsNoRegion)
{
	const Surface flat = surfaceOf(mesh, workers);
	EXPECT_TRUE(regionVertices(mesh.view(), nullptr, flat, workers).empty());
	mark([](double, double) { return false; });
	EXPECT_TRUE(regionVertices(mesh.view(), marks.data(), flat, workers).empty());
	EXPECT_TRUE(callersVertices(mesh.view(), Buffer<char>(), flat, workers).empty());
}

TEST_F(FeatureRegionTest, MarkedVerticesAreTheCallers)
{
	const Surface flat = surfaceOf(mesh, workers);
	mark([](double x, double) { return x > 0.55; });
	const Buffer<char> in = regionVertices(mesh.view(), marks.data(), flat, workers);
	ASSERT_EQ(in.size(), mesh.vertexNum());
	for (int v = 0; v < flat.mesh.vertexNum; ++v)
		EXPECT_EQ(in[v] != 0, flat.frame.toCaller(flat.mesh.position[v]).x > 0.55);
	EXPECT_EQ(callersVertices(mesh.view(), in, flat, workers).size(), 5u * 11u);
}

/// Vertices made by splits between marked vertices belong to the region, but are no input vertices.
TEST_F(FeatureRegionTest, SplitsBetweenMarkedVerticesBelongToIt)
{
	mark([](double x, double) { return x > 0.55; });
	const Surface fine = splitSurface(0.04);
	ASSERT_GT(fine.mesh.vertexNum, 4 * int(mesh.vertexNum()));
	const Buffer<char> in = regionVertices(mesh.view(), marks.data(), fine, workers);
	for (int v = 0; v < fine.mesh.vertexNum; ++v)
		EXPECT_EQ(in[v] != 0, fine.frame.toCaller(fine.mesh.position[v]).x > 0.599);
	const std::vector<int> callers = callersVertices(mesh.view(), in, fine, workers);
	EXPECT_EQ(callers.size(), 5u * 11u);
	for (int v : callers) {
		const double cells = 10 * fine.frame.toCaller(fine.mesh.position[v]).x;
		EXPECT_NEAR(cells, std::round(cells), 1e-5);
	}
}

class KeptOnCurves : public ::testing::Test {
protected:
	Workers workers{1, nullptr};

	/// Expects every vertex of the list to be a pinned sample at its very place, once.
	static void expectKept(const Surface& surface, const std::vector<int>& kept,
						   const BoundaryCurves& b)
	{
		std::set<int> found;
		for (const CurveSample& s : b.samples) {
			if (!s.isPinned) continue;
			EXPECT_TRUE(s.isCorner);
			EXPECT_TRUE(found.insert(s.vertex).second) << "twice";
			EXPECT_EQ(length(s.point.position - surface.mesh.position[s.vertex]), 0);
		}
		EXPECT_EQ(found, std::set<int>(kept.begin(), kept.end()));
	}
};

TEST_F(KeptOnCurves, OnTheBorderAndInside)
{
	for (const float spacing : {0.05f, 0.3f, 2.0f}) {
		const Surface    s = surfaceOf(grid(12, 12), workers);
		std::vector<int> kept;
		for (int v = 0; v < s.mesh.vertexNum; ++v) {
			if (s.frame.toCaller(s.mesh.position[v]).x < 0.1) kept.push_back(v); // two columns
		}
		ASSERT_EQ(kept.size(), 26u);
		expectKept(s, kept, sampleBoundary(s, spacing / 1.04f, spacing, workers, {}, kept));
	}
}

TEST_F(KeptOnCurves, OnFeatureLinesTheirNodesAndTips)
{
	Surface s = surfaceOf(cube(6), workers);
	s.mesh.crease.reset(s.mesh.halfEdgeNum());
	std::vector<int> all;
	for (int h = 0; h < s.mesh.halfEdgeNum(); ++h) {
		const Vec3f a = s.mesh.faceNormal(h / 3), b = s.mesh.faceNormal(s.mesh.opposite[h] / 3);
		s.mesh.crease[h] = dot(a, b) < 0.5f;
	}
	for (int v = 0; v < s.mesh.vertexNum; v += 2)
		all.push_back(v);
	const std::vector<int> coneApexes = {all[3]};
	expectKept(s, all, sampleBoundary(s, 0.2f, 0.2f, workers, coneApexes, all));
}

TEST_F(KeptOnCurves, NoneChangesNothing)
{
	const Surface        s = surfaceOf(grid(12, 12), workers);
	const BoundaryCurves b = sampleBoundary(s, 0.2f, 0.2f, workers);
	for (const CurveSample& sample : b.samples)
		EXPECT_FALSE(sample.isPinned);
}

} // namespace

} // namespace gpr::test
