// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_extras/core/surface/barycentric_point.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A point's place on a triangle of the caller's.
BarycentricPoint placeOn(const TriangleMesh& triangle, const Vec3f& p)
{
	Surface surface;
	surface.sourceFace.resize(1);
	surface.sourceFace[0] = 0;
	return barycentricPoint(triangle.view(), surface, {p, 0});
}

Vec3d pointOf(const TriangleMesh& m, const BarycentricPoint& at)
{
	Vec3d p;
	for (int k = 0; k < 3; ++k)
		p += m.positions[k] * double(at.weight[k]);
	return p;
}

TEST(BarycentricPoint, WeightsGiveThePointBack)
{
	const TriangleMesh m{{{0, 0, 0}, {2, 0, 1}, {0, 3, 1}}, {0, 1, 2}};
	const Vec3d        p = m.positions[0] * 0.2 + m.positions[1] * 0.5 + m.positions[2] * 0.3;
	EXPECT_LT(length(pointOf(m, placeOn(m, Vec3f(p))) - p), 1e-6);
}

/// All corners in a line, in each order; they were given to the first corner.
TEST(BarycentricPoint, OnAFaceWithoutAreaItIsTheNearestOne)
{
	const Vec3d a(0, 0, 0), b(1, 2, 3), c(3, 6, 9.0000000000001);
	for (const auto& corners : {std::vector<Vec3d>{a, b, c}, {b, c, a}, {c, a, b}, {b, a, c}}) {
		const TriangleMesh m{corners, {0, 1, 2}};
		const Vec3d        p = c * 0.7;
		EXPECT_LT(length(pointOf(m, placeOn(m, Vec3f(p))) - p), 1e-5);
		EXPECT_LT(length(pointOf(m, placeOn(m, Vec3f(-1, -1, -1))) - a), 1e-5);
	}
}

TEST(BarycentricPoint, OnAFaceThatIsAPointItIsThatPoint)
{
	const TriangleMesh     m{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {0, 1, 2}};
	const BarycentricPoint at = placeOn(m, {5, 5, 5});
	EXPECT_EQ(at.weight[0] + at.weight[1] + at.weight[2], 1);
}

} // namespace

} // namespace gpr::test
