// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The distance from a triangle to the surface above, proven by the degree of a projection.

#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/random_source.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/surface/cover_bound.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr double none = HUGE_VAL;

/// Inside of the unit square.
const Triangle piece = {Vec3d(0.2, 0.2, 0), Vec3d(0.8, 0.3, 0), Vec3d(0.4, 0.7, 0)};

double boundOver(const TriangleMesh& mesh, const Triangle& triangle, double limit)
{
	Workers            workers(1, nullptr);
	const TriangleTree tree(mesh.view(), Vec3d(), workers);
	const Vec3d        middle = (triangle[0] + triangle[1] + triangle[2]) * (1.0 / 3);
	return coverBound(triangle, tree, tree.nearest(middle).triangle, limit, 1e-14);
}

TriangleMesh raised(TriangleMesh mesh, const std::function<double(const Vec3d&)>& height)
{
	for (Vec3d& p : mesh.positions)
		p.z = height(p);
	return mesh;
}

Vec3d somewhereIn(const Triangle& t, Random& random)
{
	double u = random.unit(), v = random.unit();
	if (u + v > 1) {
		u = 1 - u;
		v = 1 - v;
	}
	return t[0] + (t[1] - t[0]) * u + (t[2] - t[0]) * v;
}

} // namespace

TEST(CoverBound, OfAPlaneIsItsHeight)
{
	const TriangleMesh plane = raised(grid(13, 13), [](const Vec3d&) { return 0.01; });
	EXPECT_NEAR(boundOver(plane, piece, 1), 0.01, 1e-12);
	EXPECT_EQ(boundOver(plane, piece, 0.009), none);
	EXPECT_NEAR(boundOver(insideOut(plane), piece, 1), 0.01, 1e-12);
	const TriangleMesh one = raised(grid(1, 1), [](const Vec3d&) { return -0.02; });
	EXPECT_NEAR(boundOver(one, piece, 1), 0.02, 1e-12);
}

TEST(CoverBound, OfARampIsItsLargestHeightOverThePiece)
{
	const TriangleMesh ramp = raised(grid(3, 3), [](const Vec3d& p) { return 0.1 * p.x; });
	EXPECT_NEAR(boundOver(ramp, piece, 0.0801), 0.08, 1e-9)
		<< "what is beside the piece is cut off";
	EXPECT_EQ(boundOver(ramp, piece, 0.0799), none);
}

TEST(CoverBound, AHoleOverThePieceIsNoCover)
{
	Random       random(1);
	TriangleMesh holed = gridWhere(12, 1, [](int i, int j) { return i != 5 || j != 5; });
	EXPECT_EQ(boundOver(holed, piece, 1), none);
	TriangleMesh beside = gridWhere(12, 1, [](int i, int j) { return i != 11 || j != 1; });
	EXPECT_NEAR(boundOver(beside, piece, 1), 0, 1e-12);
	EXPECT_EQ(boundOver(soupOf(grid(6, 6), 0, random), piece, 1), none);
}

/// Walls above the piece: three layers cover the piece, two do not.
TEST(CoverBound, FoldsCountByTheirNumber)
{
	const auto folded = [](double x) {
		if (x < 0.5) return Vec3d(x, 0, 0);
		return x < 0.6 ? Vec3d(1 - x, 0, x - 0.5) : Vec3d(x - 0.2, 0, 0.1);
	};
	TriangleMesh sheet = grid(24, 6, 1.2, 1);
	for (Vec3d& p : sheet.positions)
		p = folded(p.x) + Vec3d(0, p.y, 0);
	EXPECT_NEAR(boundOver(sheet, piece, 0.2), 0.1, 1e-9);
	TriangleMesh half = grid(12, 6, 0.6, 1);
	for (Vec3d& p : half.positions)
		p = folded(p.x) + Vec3d(0, p.y, 0);
	EXPECT_EQ(boundOver(half, piece, 0.2), none);
}

TEST(CoverBound, GivesUpOnNeedlesAndOnVeryManyTriangles)
{
	const Triangle needle = {Vec3d(0.2, 0.2, 0), Vec3d(0.8, 0.2, 0), Vec3d(0.5, 0.2 + 1e-9, 0)};
	const Triangle point  = {Vec3d(0.2, 0.2, 0), Vec3d(0.2, 0.2, 0), Vec3d(0.2, 0.2, 0)};
	EXPECT_EQ(boundOver(grid(4, 4), needle, 1), none);
	EXPECT_EQ(boundOver(grid(4, 4), point, 1), none);
	EXPECT_EQ(boundOver(grid(100, 100), piece, 1), none);
}

TEST(CoverBound, NoPointIsFarther)
{
	int provenNum = 0;
	for (const std::uint32_t seed : testSeeds(200)) {
		Random       random(seed);
		TriangleMesh mesh = randomSurface(random);
		for (Vec3d& p : mesh.positions)
			p += Vec3d(random.between(-0.02, 0.02), random.between(-0.02, 0.02),
					   random.between(-0.02, 0.02));
		const std::size_t f = std::size_t(random.below(int(mesh.faceNum())));
		Triangle          t;
		for (std::size_t k = 0; k < 3; ++k)
			t[k] = mesh.positions[std::size_t(mesh.triangles[3 * f + k])];
		const Vec3d middle = (t[0] + t[1] + t[2]) * (1.0 / 3);
		for (Vec3d& p : t) // two to four times as large, and moved
			p = middle + (p - middle) * random.between(2, 4) +
				Vec3d(0, 0, random.between(-0.05, 0.05));
		const double bound = boundOver(mesh, t, 0.5);
		if (bound == none) continue;
		++provenNum;
		for (int i = 0; i < 100; ++i)
			EXPECT_LE(distanceToMesh(mesh, somewhereIn(t, random)), bound + 1e-9)
				<< "seed " << seed;
	}
	EXPECT_GT(provenNum, 40) << "else little was tested";
}

} // namespace gpr::test
