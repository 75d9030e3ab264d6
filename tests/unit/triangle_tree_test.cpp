// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/random_source.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/surface/triangle_tree.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace gpr::test {

namespace {

Vec3d somePoint(Random& random, double reach)
{
	return {random.between(-reach, reach), random.between(-reach, reach),
			random.between(-reach, reach)};
}

TriangleTree treeOf(const TriangleMesh& mesh, int threads = 2)
{
	Workers workers(threads, nullptr);
	return TriangleTree(mesh.view(), Vec3d(), workers);
}

/// The number of pairs of common corners of two triangles.
int commonCorners(const Triangle& a, const Triangle& b)
{
	int num = 0;
	for (const Vec3d& p : a)
		for (const Vec3d& q : b)
			num += p == q;
	return num;
}

} // namespace

TEST(SquaredDistance, AgreesWithTheOracle)
{
	Random random(1);
	for (int i = 0; i < 20000; ++i) {
		const Triangle t = {somePoint(random, 1), somePoint(random, 1), somePoint(random, 1)};
		const Vec3d    p = somePoint(random, 3);
		EXPECT_NEAR(std::sqrt(squaredDistance(p, t)), distanceToTriangle(p, t[0], t[1], t[2]),
					1e-9);
	}
}

TEST(SquaredDistance, OfNeedlesIsThatOfTheirOutline)
{
	Random random(2);
	for (int i = 0; i < 20000; ++i) {
		const Vec3d  a = somePoint(random, 1), b = somePoint(random, 1);
		const double width   = std::pow(10, random.between(-18, -9));
		const Vec3d  c       = a + (b - a) * random.between(-1, 2) + somePoint(random, width);
		const Vec3d  p       = somePoint(random, 3);
		const double outline = std::min(
			{distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
		EXPECT_NEAR(std::sqrt(squaredDistance(p, {a, b, c})), outline, 2e-8);
	}
	const Vec3d point(1, 2, 3);
	EXPECT_DOUBLE_EQ(squaredDistance({1, 2, 5}, {point, point, point}), 4);
}

TEST(TriangleTree, FindsWhatComparingAllFinds)
{
	Random random(3);
	for (const TriangleMesh& mesh : {noisySphere(3, 0.2, random), thinPlate(10, 0.01), grid(1, 1),
									 soupOf(cube(4), 0, random)}) {
		const TriangleTree tree = treeOf(mesh);
		ASSERT_EQ(tree.size(), int(mesh.faceNum()));
		for (int i = 0; i < 300; ++i) {
			const Vec3d  p        = somePoint(random, 2);
			const auto   near     = tree.nearest(p);
			const auto   hinted   = tree.nearest(p, random.below(tree.size()));
			const double expected = distanceToMesh(mesh, p);
			EXPECT_NEAR(std::sqrt(near.squared), expected, 1e-12);
			EXPECT_EQ(near.squared, hinted.squared);
			EXPECT_EQ(squaredDistance(p, tree.triangle(near.triangle)), near.squared);
		}
	}
}

TEST(TriangleTree, KnowsTheNeighbours)
{
	const TriangleTree closed = treeOf(icosphere(3));
	for (int t = 0; t < closed.size(); ++t) {
		std::set<int> all;
		for (int k = 0; k < 3; ++k) {
			const int next = closed.neighbour(t, k);
			ASSERT_GE(next, 0);
			all.insert(next);
			EXPECT_EQ(commonCorners(closed.triangle(t), closed.triangle(next)), 2);
			const Vec3d& a = closed.triangle(t)[std::size_t(k)];
			EXPECT_EQ(commonCorners({a, a, a}, closed.triangle(next)), 3)
				<< "the edge begins at corner k";
		}
		EXPECT_EQ(all.size(), 3u);
	}
	const TriangleTree fins = treeOf(finsOnEdge(3));
	for (int t = 0; t < fins.size(); ++t)
		for (int k = 0; k < 3; ++k)
			EXPECT_EQ(fins.neighbour(t, k), -1) << "edges of one triangle or of three";
	const TriangleTree open = treeOf(grid(5, 4));
	int                rim  = 0;
	for (int t = 0; t < open.size(); ++t)
		for (int k = 0; k < 3; ++k)
			rim += open.neighbour(t, k) < 0;
	EXPECT_EQ(rim, 18);
}

TEST(TriangleTree, GroupsHoldTheirTriangles)
{
	const TriangleTree tree = treeOf(torus(23, 17));
	for (int level = 0; level < tree.levelNum(); ++level) {
		EXPECT_EQ(tree.groupBegin(level, 0), 0);
		EXPECT_EQ(tree.groupBegin(level, 1 << level), tree.size());
		for (int i = 0; i < 1 << level; ++i) {
			const Box<float>& box = tree.groupBox(level, i);
			for (int t = tree.groupBegin(level, i); t < tree.groupBegin(level, i + 1); ++t) {
				for (const Vec3d& p : tree.triangle(t)) {
					EXPECT_TRUE(double(box.low.x) <= p.x && p.x <= double(box.high.x));
					EXPECT_TRUE(double(box.low.y) <= p.y && p.y <= double(box.high.y));
					EXPECT_TRUE(double(box.low.z) <= p.z && p.z <= double(box.high.z));
				}
			}
		}
	}
}

TEST(TriangleTree, LeavesOutWhatIsNoTriangle)
{
	TriangleMesh wild = grid(2, 2);
	wild.positions.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
	wild.triangles.insert(wild.triangles.end(), {0, 1, 9, 1, 1, 2, 0, 1, 777, 0, -1, 2});
	EXPECT_EQ(treeOf(wild).size(), 8);
	EXPECT_EQ(treeOf(TriangleMesh()).size(), 0);
}

TEST(TriangleTree, IsTheSameForAnyNumberOfThreads)
{
	const TriangleMesh mesh = icosphere(5);
	const TriangleTree one  = treeOf(mesh, 1);
	for (const int threads : {2, 3}) {
		const TriangleTree more = treeOf(mesh, threads);
		ASSERT_EQ(one.size(), more.size());
		for (int t = 0; t < one.size(); ++t) {
			ASSERT_EQ(one.triangle(t), more.triangle(t));
			for (int k = 0; k < 3; ++k)
				ASSERT_EQ(one.neighbour(t, k), more.neighbour(t, k));
		}
	}
}

} // namespace gpr::test
