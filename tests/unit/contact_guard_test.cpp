// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether a change would make a new contact.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/guard/contact_guard.h>

#include <gtest/gtest.h>
#include <vector>

namespace gpr::test {

namespace {

/// A triangle in the plane y = 0 round (x, 0, z), a unit wide.
TriangleMesh upright(double x, double z = 0)
{
	return {{{x - 0.5, 0, z - 0.5}, {x + 0.5, 0, z - 0.5}, {x, 0, z + 0.5}}, {0, 1, 2}};
}

/// The same in the plane z = 0.
TriangleMesh lying(double x)
{
	return {{{x - 0.5, -0.5, 0}, {x + 0.5, -0.5, 0}, {x, 0.5, 0}}, {0, 1, 2}};
}

/// Triangles with no vertex in common.
HalfEdgeMesh apart(const std::vector<TriangleMesh>& triangles)
{
	TriangleMesh all;
	for (const TriangleMesh& t : triangles) {
		for (int k = 0; k < 3; ++k) {
			all.triangles.push_back(std::int32_t(all.positions.size()));
			all.positions.push_back(t.positions[std::size_t(k)]);
		}
	}
	return halfEdgesOf(all);
}

NamedTriangle moved(const HalfEdgeMesh& m, int face, const Vec3f& by)
{
	NamedTriangle t = triangleOf(m, face);
	for (Vec3f& p : t.at)
		p += by;
	return t;
}

/// Whether a face may be moved.
bool mayMove(ContactGuard& guard, const HalfEdgeMesh& m, int face, float x)
{
	return guard.allows({moved(m, face, {x, 0, 0})}, {face});
}

} // namespace

TEST(ContactGuard, RefusesWhatTouches)
{
	Workers            workers(1, nullptr);
	const HalfEdgeMesh m = halfEdgesOf(twoSheets(4, 0.1));
	ContactGuard       guard(m, false, workers);
	int                inner = -1;
	for (int v = 0; v < m.vertexNum && inner < 0; ++v) {
		if (!m.isBorderVertex(v) && m.position[v].z < 0.05f) inner = v;
	}
	ASSERT_GE(inner, 0);
	std::vector<int> faces;
	forEachOutgoing(m, inner, [&](int h) { faces.push_back(h / 3); });
	const auto raisedBy = [&](float height) {
		std::vector<NamedTriangle> made;
		for (int f : faces) {
			made.push_back(triangleOf(m, f));
			for (int k = 0; k < 3; ++k) {
				if (made.back().vertex[k] == inner) made.back().at[k].z += height;
			}
		}
		return made;
	};
	EXPECT_TRUE(guard.allows(raisedBy(0), faces));
	EXPECT_TRUE(guard.allows(raisedBy(0.099f), faces));
	EXPECT_FALSE(guard.allows(raisedBy(0.2f), faces));
}

TEST(ContactGuard, RefusesNewFacesThatTouchEachOther)
{
	Workers            workers(1, nullptr);
	const HalfEdgeMesh m = apart({lying(0), upright(10)});
	for (const bool hadContacts : {false, true}) {
		ContactGuard guard(m, hadContacts, workers);
		EXPECT_TRUE(guard.allows({triangleOf(m, 0), moved(m, 1, {-8, 0, 0})}, {0, 1}));
		EXPECT_FALSE(guard.allows({triangleOf(m, 0), moved(m, 1, {-10, 0, 0})}, {0, 1}));
	}
}

TEST(ContactGuard, AllowsNewFacesToTouchWhereThoseBeforeDid)
{
	Workers                          workers(1, nullptr);
	const HalfEdgeMesh               m    = apart({lying(0), upright(0)});
	const std::vector<NamedTriangle> made = {triangleOf(m, 0), moved(m, 1, {0.1f, 0, 0})};
	EXPECT_TRUE(ContactGuard(m, true, workers).allows(made, {0, 1}));
	EXPECT_FALSE(ContactGuard(m, false, workers).allows(made, {0, 1})) << "none is said to touch";
}

/// Face 0 touches face 1, and not face 2.
TEST(ContactGuard, AllowsContactsOnlyWithFacesThatWereTouchedBefore)
{
	Workers            workers(1, nullptr);
	const HalfEdgeMesh m = apart({lying(0), upright(0), upright(10)});
	ContactGuard       guard(m, true, workers);
	EXPECT_TRUE(mayMove(guard, m, 0, 0.1f)) << "it touches face 1 still";
	EXPECT_TRUE(mayMove(guard, m, 0, 5)) << "it touches none";
	EXPECT_FALSE(mayMove(guard, m, 0, 10)) << "it touches face 2";
}

TEST(ContactGuard, FollowsFacesThatHaveMoved)
{
	Workers      workers(1, nullptr);
	HalfEdgeMesh m = apart({lying(0), upright(10), upright(20)});
	ContactGuard guard(m, false, workers);
	EXPECT_TRUE(mayMove(guard, m, 0, 5));
	EXPECT_FALSE(mayMove(guard, m, 0, 10));
	for (int v = 3; v < 6; ++v)
		m.position[v].x -= 5;
	guard.follow({1});
	EXPECT_FALSE(mayMove(guard, m, 0, 5));
	EXPECT_TRUE(mayMove(guard, m, 0, 10));
}

} // namespace gpr::test
