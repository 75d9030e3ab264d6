// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves on trial: the damaged faces, and the moves that are kept.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/edit/move_guard.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// Six equilateral triangles of side 1 round the vertex 0, in the plane z = 0.
TriangleMesh hexagon()
{
	TriangleMesh mesh;
	mesh.positions.push_back({0, 0, 0});
	for (int i = 0; i < 6; ++i)
		mesh.positions.push_back({std::cos(i * pi / 3), std::sin(i * pi / 3), 0});
	for (int i = 0; i < 6; ++i)
		mesh.triangles.insert(mesh.triangles.end(), {0, 1 + i, 1 + (i + 1) % 6});
	return mesh;
}

/// The middle of the hexagon with faces tilted by this angle.
Vec3f tilted(double angleDeg)
{
	return {0, 0, float(std::sqrt(0.75) * std::tan(angleDeg * pi / 180))};
}

/// A hexagon with a moving middle, and a second hexagon apart.
struct Trial {
	Workers      workers{2, nullptr};
	HalfEdgeMesh mesh;
	MoveGuard    guard;

	explicit Trial(const Acceptance& limits, const Vec3f& start = {},
				   const Shortening& shortening = {}) :
			mesh(startingAt(start)),
			guard(limits, shortening, mesh, workers)
	{
		guard.start();
	}

	static HalfEdgeMesh startingAt(const Vec3f& start)
	{
		TriangleMesh both = hexagon();
		for (const Vec3d& p : hexagon().positions)
			both.positions.push_back(p + Vec3d(5, 0, 0));
		for (int i : hexagon().triangles)
			both.triangles.push_back(i + 7);
		HalfEdgeMesh m = halfEdgesOf(both);
		m.position[0]  = start;
		return m;
	}

	/// Moves the middle to a place; returns its place in the end.
	Vec3f move(const Vec3f& to, const Buffer<Vec3f>& normal = {})
	{
		mesh.position[0] = to;
		guard.takeOver();
		guard.settle(normal);
		return mesh.position[0];
	}

	Buffer<Vec3f> upwards() const
	{
		return Buffer<Vec3f>(std::size_t(mesh.vertexNum), Vec3f(0, 0, 1));
	}
};

/// Only the turn counts.
Acceptance turnLimits()
{
	Acceptance limits;
	limits.turn = 0.5f;
	return limits;
}

TEST(MoveGuard, AllowsNoTurnByMoreThanSixtyDegrees)
{
	for (double angle : {10.0, 58.0, 62.0, 85.0}) {
		Trial trial(turnLimits());
		EXPECT_EQ(trial.move(tilted(angle)), angle < 60 ? tilted(angle) : Vec3f()) << angle;
	}
	// Over the border of the hexagon: the face there is turned over.
	Trial trial(turnLimits());
	EXPECT_EQ(trial.move({2, 0.1f, 0}), Vec3f());
}

/// The faces end tilted by 80°; they turn by 40° or by 2°.
TEST(MoveGuard, AllowsNoFaceToAgreeLessWithTheSurfaceBelowItsBound)
{
	Acceptance limits = turnLimits();
	limits.agreement  = 0.3f; // 72.5°
	const auto ends   = [&](double from, double to, bool hasNormals) {
        Trial trial(limits, tilted(from));
        return trial.move(tilted(to), hasNormals ? trial.upwards() : Buffer<Vec3f>());
	};
	EXPECT_EQ(ends(40, 80, true), tilted(40));
	EXPECT_EQ(ends(40, 80, false), tilted(80)) << "nobody says where the surface looks";
	EXPECT_EQ(ends(40, 70, true), tilted(70)) << "above the bound";
	EXPECT_EQ(ends(82, 80, true), tilted(80)) << "below the bound, but better";
	EXPECT_EQ(ends(80, 82, true), tilted(80)) << "below the bound, and worse";
}

TEST(MoveGuard, LetsAPoorFaceGetNoPoorer)
{
	Acceptance shape = turnLimits(), angle = turnLimits();
	shape.shape = 0.6f; // of 30°-30°-120°
	angle.angle = 32 * radians;
	for (const Acceptance& limits : {shape, angle}) {
		EXPECT_EQ(Trial(limits).move({0.1f, 0, 0}), Vec3f(0.1f, 0, 0)) << "no face is poor";
		EXPECT_EQ(Trial(limits).move({0.8f, 0, 0}), Vec3f()) << "one becomes poor";
		EXPECT_EQ(Trial(limits, {0.8f, 0, 0}).move({0.85f, 0, 0}), Vec3f(0.8f, 0, 0));
		EXPECT_EQ(Trial(limits, {0.8f, 0, 0}).move({0.75f, 0, 0}), Vec3f(0.75f, 0, 0));
	}
}

TEST(MoveGuard, TakesRoundingForNoFall)
{
	Acceptance limits = turnLimits();
	limits.angle      = 32 * radians;
	const Vec3f from = {0.8f, 0, 0}, to = {0.80001f, 0, 0};
	EXPECT_EQ(Trial(limits, from).move(to), from);
	limits.falls = 0.999f;
	EXPECT_EQ(Trial(limits, from).move(to), to);
}

TEST(MoveGuard, HalvesMovesBeforeItTakesThemBack)
{
	Shortening shortening;
	shortening.halvings = 1;
	EXPECT_EQ(Trial(turnLimits(), {}, shortening).move(tilted(70)), tilted(70) * 0.5f);
	// Half of this is still too far.
	EXPECT_EQ(Trial(turnLimits(), {}, shortening).move(tilted(85)), Vec3f());
	shortening.halvings = 3;
	EXPECT_EQ(Trial(turnLimits(), {}, shortening).move(tilted(85)), tilted(85) * 0.125f);
}

TEST(MoveGuard, TakesAllBackWhereThereIsNoEnd)
{
	Trial trial(turnLimits(), {}, Shortening{9, 2});
	trial.mesh.position[0] = tilted(89);
	trial.mesh.position[7] = {5.1f, 0, 0}; // harms nobody
	trial.guard.takeOver();
	EXPECT_FALSE(trial.guard.settle());
	EXPECT_EQ(trial.mesh.position[0], Vec3f());
	EXPECT_EQ(trial.mesh.position[7], Vec3f(5, 0, 0));
}

TEST(MoveGuard, TakesMovesBackOnDemand)
{
	Trial trial(turnLimits());
	trial.mesh.position[0] = {0.1f, 0, 0};
	trial.mesh.position[7] = {5.1f, 0, 0};
	trial.guard.takeOver();
	EXPECT_TRUE(trial.guard.hasMoved(0));
	trial.guard.takeBack({0}, {});
	EXPECT_FALSE(trial.guard.hasMoved(0));
	EXPECT_EQ(trial.mesh.position[0], Vec3f());
	EXPECT_EQ(trial.mesh.position[7], Vec3f(5.1f, 0, 0));
}

TEST(SpoilsRing, IsForASingleMoveWhatTheGuardIsForAll)
{
	Acceptance limits = turnLimits();
	limits.angle      = 32 * radians;
	Trial trial(limits);
	for (const Vec3f& to : {tilted(50), tilted(65), Vec3f(0.1f, 0, 0), Vec3f(0.8f, 0, 0)}) {
		const bool spoils = spoilsRing(limits, trial.mesh, 0, to);
		EXPECT_EQ(spoils, !(Trial(limits).move(to) == to));
	}
}

} // namespace

} // namespace gpr::test
