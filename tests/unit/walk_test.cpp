// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/surface/walk.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr double pi = 3.14159265358979323846;
/// Below a quarter of a cell no triangle of a jittered grid is inverted. An inverted triangle would
/// fold the plane, and walks would not be straight.
constexpr double maxJitter = 0.24;

/// A random point of a random face.
SurfacePoint randomPoint(const HalfEdgeMesh& m, Random& random)
{
	const int f = random.below(m.faceNum);
	float     u = float(random.unit()), v = float(random.unit());
	if (u + v > 1) {
		u = 1 - u;
		v = 1 - v;
	}
	const Vec3f a = m.position[m.origin[3 * f]];
	return {a + (m.position[m.origin[3 * f + 1]] - a) * u +
				(m.position[m.origin[3 * f + 2]] - a) * v,
			f};
}

double distanceToOwnFace(const HalfEdgeMesh& m, const SurfacePoint& a)
{
	const auto corner = [&](int k) { return Vec3d(m.position[m.origin[3 * a.face + k]]); };
	return distanceToTriangle(Vec3d(a.position), corner(0), corner(1), corner(2));
}

class Walk : public ::testing::TestWithParam<std::uint32_t> {
protected:
	Random random{GetParam()};
};

TEST_P(Walk, OnAPlaneEndsExactlyWhereTheStepSays)
{
	const HalfEdgeMesh m = halfEdgesOf(jitteredGrid(30, maxJitter, random));
	for (int i = 0; i < 200; ++i) {
		SurfacePoint at   = randomPoint(m, random);
		const Vec3f  from = at.position;
		const Vec3f  goal(float(random.between(0.05, 0.95)), float(random.between(0.05, 0.95)), 0);
		ASSERT_TRUE(walk(m, at, goal - from));
		ASSERT_LT(length(at.position - goal), 7e-6f) << "some bits for each of 60 faces";
		ASSERT_LT(distanceToOwnFace(m, at), 2e-6);
	}
}

TEST_P(Walk, TheStepIsTurnedIntoTheFaceAndKeepsItsLength)
{
	const HalfEdgeMesh m  = halfEdgesOf(grid(20, 20));
	SurfacePoint       at = {{0.51f, 0.52f, 0}, -1};
	for (int f = 0; f < m.faceNum && at.face < 0; ++f) {
		SurfacePoint candidate = {at.position, f};
		if (distanceToOwnFace(m, candidate) == 0) at.face = f;
	}
	ASSERT_GE(at.face, 0);
	ASSERT_TRUE(walk(m, at, {0.06f, 0, 0.08f}));
	EXPECT_NEAR(double(at.position.x), 0.61, 1e-6);
	EXPECT_NEAR(double(at.position.y), 0.52, 1e-6);
}

/// A prism can be unrolled: the place of a point along the polygon, and its height.
TEST_P(Walk, OnAPrismIsStraightOnTheUnrolledSide)
{
	constexpr int      around = 24;
	const double       side   = 2 * std::sin(pi / around);
	const HalfEdgeMesh m      = halfEdgesOf(openCylinder(around, 40, 1, 8));
	const auto         unroll = [&](const Vec3f& p) {
        double turn = std::atan2(double(p.y), double(p.x)) / (2 * pi) * around;
        if (turn < 0) turn += around;
        const double segment = std::floor(turn);
        const double a = 2 * pi * segment / around, b = 2 * pi * (segment + 1) / around;
        const Vec3d  u(std::cos(b) - std::cos(a), std::sin(b) - std::sin(a), 0);
        const Vec3d  d(double(p.x) - std::cos(a), double(p.y) - std::sin(a), 0);
        return (segment + dot(d, u) / squaredLength(u)) * side;
	};
	for (int i = 0; i < 100; ++i) {
		SurfacePoint at = randomPoint(m, random);
		if (std::abs(at.position.z - 4) > 1) continue;
		const Vec3f  from  = at.position;
		const Vec3f  n     = m.faceNormal(at.face);
		const double along = random.between(-3, 3), up = random.between(-2, 2);
		const Vec3f  tangent = normalized(cross(Vec3f(0, 0, 1), n));
		ASSERT_TRUE(walk(m, at, tangent * float(along) + Vec3f(0, 0, float(up))));
		EXPECT_NEAR(double(at.position.z - from.z), up, 1e-5);
		const double moved = unroll(at.position) - unroll(from) - along;
		EXPECT_NEAR(std::remainder(moved, around * side), 0, 2e-5);
	}
}

TEST_P(Walk, OnASphereFollowsTheGreatCircle)
{
	const HalfEdgeMesh m = halfEdgesOf(icosphere(6));
	for (int i = 0; i < 50; ++i) {
		SurfacePoint at   = randomPoint(m, random);
		const Vec3d  from = Vec3d(at.position);
		const Vec3d  any  = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
		const Vec3d  tangent  = normalized(tangential(any, Vec3d(m.faceNormal(at.face))));
		const double distance = random.between(0.1, 2);
		ASSERT_TRUE(walk(m, at, Vec3f(tangent * distance)));
		const Vec3d goal = normalized(from) * std::cos(distance) + tangent * std::sin(distance);
		EXPECT_LT(length(normalized(Vec3d(at.position)) - normalized(goal)),
				  0.01 * distance + 0.002);
		EXPECT_LT(distanceToOwnFace(m, at), 1e-5);
	}
}

TEST_P(Walk, ThereAndBackEndsWhereItBegan)
{
	const HalfEdgeMesh m = halfEdgesOf(jitteredGrid(40, maxJitter, random));
	for (int i = 0; i < 100; ++i) {
		SurfacePoint at   = randomPoint(m, random);
		const Vec3f  from = at.position;
		const Vec3f  step(float(random.between(-0.3, 0.3)), float(random.between(-0.3, 0.3)), 0);
		if (!walk(m, at, step)) continue;
		ASSERT_TRUE(walk(m, at, step * -1.0f));
		EXPECT_LT(length(at.position - from), 2e-6f);
	}
}

TEST_P(Walk, StopsAtTheBorder)
{
	const HalfEdgeMesh m = halfEdgesOf(jitteredGrid(20, maxJitter, random));
	for (int i = 0; i < 100; ++i) {
		SurfacePoint at   = randomPoint(m, random);
		const Vec3d  from = Vec3d(at.position);
		const double turn = random.between(0, 2 * pi);
		const Vec3d  d(std::cos(turn), std::sin(turn), 0);
		ASSERT_FALSE(walk(m, at, Vec3f(d * 3.0)));
		const Vec3d p = Vec3d(at.position);
		EXPECT_NEAR(std::min({p.x, p.y, 1 - p.x, 1 - p.y}), 0, 1e-6);
		EXPECT_LT(length(cross(p - from, d)), 1e-5) << "straight until there";
	}
}

TEST_P(Walk, NeverLeavesTheSurface)
{
	const HalfEdgeMesh m = halfEdgesOf(noisySphere(3, 0.1, random));
	for (int i = 0; i < 200; ++i) {
		SurfacePoint at = randomPoint(m, random);
		const Vec3f  step(float(random.between(-1, 1)), float(random.between(-1, 1)),
						  float(random.between(-1, 1)));
		walk(m, at, step * 3.0f);
		ASSERT_LT(distanceToOwnFace(m, at), 1e-4);
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, Walk, ::testing::ValuesIn(testSeeds(4)));

TEST(WalkAtAll, GoesNowhereByAZeroStep)
{
	const HalfEdgeMesh m  = halfEdgesOf(grid(2, 2));
	SurfacePoint       at = {{0.4f, 0.1f, 0}, 0};
	EXPECT_TRUE(walk(m, at, {0, 0, 0}));
	EXPECT_TRUE(walk(m, at, {0, 0, 5})) << "nothing of it lies in the face";
	EXPECT_EQ(at.position, Vec3f(0.4f, 0.1f, 0));
}

/// Two corners of a face lie at one place, so the normal of the face has no meaning.
TEST(WalkAtAll, StaysInAFaceWithoutArea)
{
	TriangleMesh mesh;
	mesh.positions       = {{0, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}};
	mesh.triangles       = {0, 1, 2, 0, 2, 3};
	const HalfEdgeMesh m = halfEdgesOf(mesh);
	for (const Vec3f& step : {Vec3f(0.1f, 0.2f, 0.1f), Vec3f(0.2f, -0.1f, 0), Vec3f(3, 2, 1)}) {
		SurfacePoint at = {{0.5f, 0.5f, 0}, 0};
		EXPECT_FALSE(walk(m, at, step));
		EXPECT_EQ(at.position, Vec3f(0.5f, 0.5f, 0));
	}
}

/// Rounding of the needle's height turns the normal by some degrees.
TEST_P(Walk, DoesNotLeaveANeedle)
{
	TriangleMesh mesh;
	mesh.positions       = {{0.3, 0.1, 0.2}, {0.9, 0.8, 0.7}, {0.600001, 0.45, 0.45}};
	mesh.triangles       = {0, 1, 2};
	const HalfEdgeMesh m = halfEdgesOf(mesh);
	for (int i = 0; i < 100; ++i) {
		SurfacePoint at    = randomPoint(m, random);
		const Vec3f  along = (m.position[1] - m.position[0]) * float(random.between(-0.5, 0.5));
		walk(m, at, along);
		ASSERT_LT(distanceToOwnFace(m, at), 1e-6);
	}
}

TEST(WalkAtAll, EndsByItsBound)
{
	const HalfEdgeMesh m  = halfEdgesOf(icosphere(4));
	SurfacePoint       at = {m.position[m.origin[0]], 0};
	EXPECT_FALSE(walk(m, at, Vec3f(1, 0.3f, 0.2f) * 1000.0f, 50));
	EXPECT_LT(distanceToOwnFace(m, at), 1e-4);
}

/// Rounding turns the normal and the plane of a face less than a thousandth as high as long.
TEST(WalkAtAll, StaysInTheNeedleThatItBeginsIn)
{
	Random       random(3);
	double       farthest = 0;
	TriangleMesh needle;
	needle.triangles = {0, 1, 2};
	for (int i = 0; i < 2000; ++i) {
		const auto direction = [&] {
			return normalized(
				Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
		};
		const Vec3d along = direction(), across = normalized(cross(along, direction()));
		const Vec3d a = direction() * 0.5, b = a + along;
		const Vec3d c         = a + along * 0.5 + across * random.between(2e-5, 4e-4);
		needle.positions      = {a, b, c};
		const HalfEdgeMesh m  = halfEdgesOf(needle);
		SurfacePoint       at = {Vec3f((a + b + c) * (1 / 3.0)), 0};
		walk(m, at, Vec3f(along * random.between(-0.2, 0.2)));
		farthest = std::max(farthest, distanceToTriangle(Vec3d(at.position), a, b, c));
	}
	EXPECT_LT(farthest, 1e-6);
}

} // namespace

} // namespace gpr::test
