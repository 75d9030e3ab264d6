// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether a change would take a mesh farther from its assigned points.

#include <tests/support/stages.h>
#include <vcg_extras/core/guard/distance_guard.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <gtest/gtest.h>
#include <vector>

namespace gpr::test {

namespace {

/// The distance by which points may move away.
constexpr double enough = 0.1;

/// A square of two triangles; each vertex is its own assigned point.
GuardedMesh square()
{
	return {halfEdgesOf({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3}}), false};
}

/// The faces after raising a vertex.
std::vector<NamedTriangle> raised(const GuardedMesh& g, int v, float height)
{
	std::vector<NamedTriangle> made;
	for (int f = 0; f < g.mesh.faceNum; ++f) {
		made.push_back(triangleOf(g.mesh, f));
		for (int k = 0; k < 3; ++k) {
			if (made.back().vertex[k] == v) made.back().at[k].z += height;
		}
	}
	return made;
}

/// Whether vertex 0 may be raised.
bool mayRaise(const GuardedMesh& g, float height)
{
	Workers workers(1, nullptr);
	return DistanceGuard(g, enough, workers).allows(raised(g, 0, height), {0, 1});
}

} // namespace

TEST(DistanceGuard, AllowsWhatStaysNearEnough)
{
	const GuardedMesh g = square();
	EXPECT_TRUE(mayRaise(g, 0));
	EXPECT_TRUE(mayRaise(g, 0.09f));
	EXPECT_FALSE(mayRaise(g, 0.2f));
	EXPECT_FALSE(mayRaise(g, -0.2f));
}

TEST(DistanceGuard, AllowsWhatIsAsFarAsBefore)
{
	GuardedMesh g = square();
	g.vertex[2].points.push_back({0.9f, 0.5f, -0.3f});
	EXPECT_TRUE(mayRaise(g, 0));
	EXPECT_TRUE(mayRaise(g, -0.25f)) << "vertex 0 goes no farther than that point is off";
	EXPECT_FALSE(mayRaise(g, 0.25f));
}

/// Assigned points of a fixed vertex lie on faces that a neighbour may move.
TEST(DistanceGuard, LooksAtPointsOfFixedVerticesBesideOthers)
{
	GuardedMesh g = square();
	g.vertex[0].points.clear();
	g.vertex[2].points.push_back({0.1f, 0.1f, 0});
	for (int v : {1, 2, 3})
		g.vertex[std::size_t(v)].isFixed = true;
	EXPECT_FALSE(mayRaise(g, 0.3f));
	g.vertex[0].isFixed = true;
	EXPECT_TRUE(mayRaise(g, 0.3f)) << "nothing is said to move";
}

TEST(DistanceGuard, PointsGoToTheNearestOfTheChangedFaces)
{
	Workers     workers(1, nullptr);
	GuardedMesh g = square();
	for (GuardedVertex& v : g.vertex)
		v.points.clear();
	g.vertex[1].points.push_back({0.9f, 0.5f, 0}); // in face 0, on the side of vertex 1
	DistanceGuard guard(g, enough, workers);
	int           diagonal = 0;
	while (g.mesh.opposite[diagonal] < 0)
		++diagonal;
	flip(g.mesh, diagonal);
	guard.follow({0, 1});
	const auto mayRaise = [&](int face) {
		NamedTriangle t = triangleOf(g.mesh, face);
		for (Vec3f& p : t.at)
			p.z += 1;
		return guard.allows({t}, {face});
	};
	const auto holds = [&](int face) {
		const int* corner = &g.mesh.origin[3 * face];
		return corner[0] != 0 && corner[1] != 0 && corner[2] != 0; // the face 1, 2, 3
	};
	for (int f : {0, 1})
		EXPECT_EQ(mayRaise(f), !holds(f)) << f;
}

} // namespace gpr::test
