// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/random_source.h>
#include <vcg_extras/core/retriangulation/polygon_delaunay.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

constexpr double pi = 3.14159265358979323846;

using Diagonal = std::pair<int, int>;

double doubledArea(const Vec2d& a, const Vec2d& b, const Vec2d& c)
{
	return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double doubledArea(const std::vector<Vec2d>& polygon)
{
	double sum = 0;
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		const Vec2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
		sum += a.x * b.y - a.y * b.x;
	}
	return sum;
}

/// Positive if d lies within the circle through a, b, c (counter-clockwise).
double inCircle(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d)
{
	const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y;
	const double cx = c.x - d.x, cy = c.y - d.y;
	return (ax * ax + ay * ay) * (bx * cy - by * cx) - (bx * bx + by * by) * (ax * cy - ay * cx) +
		   (cx * cx + cy * cy) * (ax * by - ay * bx);
}

std::set<Diagonal> diagonalsOf(const HolePatch& patch)
{
	std::set<Diagonal> diagonals;
	for (int x = 0; x < int(patch.corner.size()); ++x) {
		const int a = patch.corner[x], b = patch.corner[nextInFace(x)];
		if (patch.across[x] >= 0) diagonals.insert({std::min(a, b), std::max(a, b)});
	}
	return diagonals;
}

/// Expects triangles of positive area that fill the polygon without overlap.
void expectFills(const std::vector<Vec2d>& polygon, const HolePatch& patch)
{
	ASSERT_EQ(patch.triangleNum(), int(polygon.size()) - 2);
	double sum = 0;
	for (std::size_t x = 0; x < patch.corner.size(); x += 3) {
		const double area = doubledArea(polygon[patch.corner[x]], polygon[patch.corner[x + 1]],
										polygon[patch.corner[x + 2]]);
		EXPECT_GT(area, 0);
		sum += area;
	}
	EXPECT_NEAR(sum, doubledArea(polygon), 1e-9);
	EXPECT_EQ(diagonalsOf(patch).size(), polygon.size() - 3);
}

/// Expects no apex beyond a diagonal within the circle of the triangle before the diagonal.
void expectLocallyDelaunay(const std::vector<Vec2d>& polygon, const HolePatch& patch)
{
	for (int x = 0; x < int(patch.corner.size()); ++x) {
		if (patch.across[x] < 0) continue;
		const int apex = patch.corner[prevInFace(patch.across[x])];
		EXPECT_LE(inCircle(polygon[patch.corner[x]], polygon[patch.corner[nextInFace(x)]],
						   polygon[patch.corner[prevInFace(x)]], polygon[apex]),
				  1e-7);
	}
}

std::vector<Vec2d> regular(int n)
{
	std::vector<Vec2d> polygon;
	for (int i = 0; i < n; ++i)
		polygon.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)});
	return polygon;
}

/// A polygon whose points are all visible from the origin.
std::vector<Vec2d> randomStar(int n, double minRadius, Random& random)
{
	std::vector<Vec2d> polygon;
	for (int i = 0; i < n; ++i) {
		const double angle = 2 * pi * (i + random.between(0, 0.8)) / n;
		const double r     = random.between(minRadius, 1);
		polygon.push_back({r * std::cos(angle), r * std::sin(angle)});
	}
	return polygon;
}

TEST(PolygonDelaunay, FillsRegularPolygonsOfEveryKind)
{
	PolygonDelaunay delaunay;
	HolePatch       patch;
	for (int n = 3; n <= 40; ++n) {
		ASSERT_TRUE(delaunay.triangulate(regular(n), patch)) << n;
		expectFills(regular(n), patch);
		expectLocallyDelaunay(regular(n), patch);
	}
}

/// The shorter diagonal of a kite is the Delaunay diagonal, whichever corner comes first.
TEST(PolygonDelaunay, TakesTheShorterDiagonalOfAKite)
{
	std::vector<Vec2d> kite{{2, 0}, {0, 1}, {-2, 0}, {0, -1}};
	PolygonDelaunay    delaunay;
	HolePatch          patch;
	for (int turned = 0; turned < 4; ++turned) {
		ASSERT_TRUE(delaunay.triangulate(kite, patch));
		const Diagonal shorter = turned % 2 == 0 ? Diagonal(1, 3) : Diagonal(0, 2);
		EXPECT_EQ(diagonalsOf(patch), std::set<Diagonal>{shorter});
		std::rotate(kite.begin(), kite.begin() + 1, kite.end());
	}
}

///   5---4
///   |   |         Diagonals must not cross the reflex corner 3 of an L.
///   |   3---2
///   |       |
///   0-------1
TEST(PolygonDelaunay, StaysWithinAnL)
{
	const std::vector<Vec2d> ell{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
	PolygonDelaunay          delaunay;
	HolePatch                patch;
	ASSERT_TRUE(delaunay.triangulate(ell, patch));
	expectFills(ell, patch);
	EXPECT_EQ(diagonalsOf(patch).count({0, 3}), 1u) << "both squares end at the reflex corner";
}

/// A notch between two corners: the circle contains a corner that the notch hides, which a
/// constrained triangulation may ignore.
TEST(PolygonDelaunay, IsConstrainedByTheEdges)
{
	const std::vector<Vec2d> notched{{-3, -1}, {3, -1}, {3, 1}, {0, -0.6}, {-3, 1}};
	PolygonDelaunay          delaunay;
	HolePatch                patch;
	ASSERT_TRUE(delaunay.triangulate(notched, patch));
	expectFills(notched, patch);
	EXPECT_EQ(diagonalsOf(patch), (std::set<Diagonal>{{0, 3}, {1, 3}}));
}

TEST(PolygonDelaunay, KeepsOffForbiddenDiagonals)
{
	const std::vector<Vec2d> kite{{2, 0}, {0, 1}, {-2, 0}, {0, -1}};
	PolygonDelaunay          delaunay;
	HolePatch                patch;
	delaunay.forbidden = {{3, 1}};
	ASSERT_TRUE(delaunay.triangulate(kite, patch));
	EXPECT_EQ(diagonalsOf(patch), (std::set<Diagonal>{{0, 2}}));
	delaunay.forbidden = {{3, 1}, {0, 2}};
	EXPECT_FALSE(delaunay.triangulate(kite, patch));
	delaunay.forbidden = {{0, 2}};
	EXPECT_TRUE(delaunay.triangulate(regular(3), patch)) << "the last triangle has no diagonal";
}

TEST(PolygonDelaunay, RefusesWhatHasNoInside)
{
	PolygonDelaunay delaunay;
	HolePatch       patch;
	EXPECT_FALSE(delaunay.triangulate({}, patch));
	EXPECT_FALSE(delaunay.triangulate({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, patch)) << "in line";
	EXPECT_FALSE(delaunay.triangulate({{0, 0}, {0, 0}, {0, 0}}, patch)) << "one point";
	EXPECT_FALSE(delaunay.triangulate({{0, 0}, {0, 1}, {1, 0}}, patch)) << "clockwise";
	EXPECT_FALSE(delaunay.triangulate({{0, 0}, {1, 0}, {NAN, 1}}, patch));
	EXPECT_TRUE(delaunay.triangulate({{0, 0}, {1, 0}}, patch)) << "nothing to fill";
}

class RandomPolygons : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomPolygons, AreFilledAndLocallyDelaunay)
{
	Random          random(GetParam());
	PolygonDelaunay delaunay;
	HolePatch       patch;
	for (int i = 0; i < 300; ++i) {
		const auto polygon = randomStar(3 + random.below(15), 0.2, random);
		ASSERT_TRUE(delaunay.triangulate(polygon, patch));
		expectFills(polygon, patch);
		expectLocallyDelaunay(polygon, patch);
	}
}

/// In a convex polygon nothing hides: every circle is empty of every corner.
TEST_P(RandomPolygons, OfConvexShapeHaveEmptyCircles)
{
	Random          random(GetParam());
	PolygonDelaunay delaunay;
	HolePatch       patch;
	for (int i = 0; i < 100; ++i) {
		std::vector<Vec2d> polygon = randomStar(4 + random.below(12), 1, random);
		for (Vec2d& p : polygon)
			p.x *= 2; // an ellipse, so corners are not on a circle
		ASSERT_TRUE(delaunay.triangulate(polygon, patch));
		for (std::size_t x = 0; x < patch.corner.size(); x += 3) {
			for (const Vec2d& p : polygon) {
				EXPECT_LE(inCircle(polygon[patch.corner[x]], polygon[patch.corner[x + 1]],
								   polygon[patch.corner[x + 2]], p),
						  1e-7);
			}
		}
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPolygons, ::testing::ValuesIn(testSeeds(4)));

} // namespace

} // namespace gpr::test
