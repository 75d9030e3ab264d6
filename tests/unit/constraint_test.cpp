// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Freedoms of a vertex of the result, and its ways on the surface and on a curve.

#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/features/curve_slide.h>
#include <vcg_extras/core/surface/walk.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// The vertex of the result at a point of the input.
int vertexAt(const OnSurface& on, const Vec3d& p)
{
	for (int v = 0; v < on.result.mesh.vertexNum; ++v) {
		if (length(on.surface.frame.toCaller(on.result.mesh.position[v]) - p) < 1e-6) return v;
	}
	ADD_FAILURE() << "no vertex there";
	return 0;
}

TEST(ConstraintOf, FollowsFromTheMeshAndTheRecord)
{
	OnSurface  on(grid(8, 8));
	const int  inside = vertexAt(on, {0.5, 0.5, 0}), side = vertexAt(on, {0.5, 0, 0});
	const auto with = [&](int v, const auto& change) {
		const ResultVertex before = on.result.vertex[v];
		change(on.result.vertex[v]);
		const Constraint constraint = constraintOf(on.result, v);
		on.result.vertex[v]         = before;
		return constraint;
	};
	const auto asItIs       = [](ResultVertex&) {};
	const auto corner       = [](ResultVertex& r) { r.isCorner = true; };
	const auto pinned       = [](ResultVertex& r) { r.isPinned = true; };
	const auto onNoCurve    = [](ResultVertex& r) { r.curve = -1; };
	const auto ofALostCurve = [](ResultVertex& r) { r.curve = 0; };

	EXPECT_EQ(with(side, asItIs), Constraint::Curve);
	EXPECT_EQ(with(side, corner), Constraint::Fixed);
	EXPECT_EQ(with(side, pinned), Constraint::Fixed);
	EXPECT_EQ(with(side, onNoCurve), Constraint::Fixed) << "it could not slide along anything";

	EXPECT_EQ(with(inside, asItIs), Constraint::Free);
	EXPECT_EQ(with(inside, corner), Constraint::Fixed) << "a cone apex";
	EXPECT_EQ(with(inside, ofALostCurve), Constraint::Surface);
	EXPECT_EQ(with(inside, pinned), Constraint::Surface);
}

TEST(ConstraintOf, IsTheCurveOnAFeatureLineToo)
{
	OnSurface     on(grid(8, 8));
	HalfEdgeMesh& m = on.m();
	const int     v = vertexAt(on, {0.5, 0.5, 0}), w = vertexAt(on, {0.625, 0.5, 0});
	const int     h = m.findHalfEdge(v, w);
	m.crease        = Buffer<char>(std::size_t(m.halfEdgeNum()), 0);
	m.crease[h]     = 1;
	ASSERT_GE(m.opposite[h], 0);
	m.crease[m.opposite[h]] = 1;
	EXPECT_EQ(constraintOf(on.result, v), Constraint::Fixed) << "no curve is known";
	on.result.vertex[v].curve = 0;
	EXPECT_EQ(constraintOf(on.result, v), Constraint::Curve);
}

TEST(WalkBy, StaysOnTheSurfaceAndTakesTheNormalAlong)
{
	OnSurface on(uvSphere(20, 40));
	int       turned = 0;
	for (int v = 0; v < on.m().vertexNum; ++v) {
		ResultVertex& record = on.result.vertex[v];
		const Vec3f   before = record.normal;
		const Vec3f step = tangential(Vec3f(0.3f, 0.2f, 0.1f), record.normal) * on.result.idealEdge;
		EXPECT_TRUE(walkBy(on.surface, step, record));
		EXPECT_EQ(record.normal, on.surface.mesh.faceNormal(record.point.face));
		turned += !(record.normal == before);
		on.m().position[v] = record.point.position;
	}
	EXPECT_GT(turned, on.m().vertexNum / 2);
	on.expectOnSurface();
}

TEST(SlideRoom, ReachesToTheNeighboursOnTheCurve)
{
	OnSurface on(grid(8, 8));
	for (int v = 0; v < on.m().vertexNum; ++v) {
		if (constraintOf(on.result, v) != Constraint::Curve) continue;
		const SlideRoom room = slideRoom(on.result, on.boundary, v);
		ASSERT_TRUE(room.isOpen());
		const ResultVertex& here = on.result.vertex[v];
		const auto          end  = [&](float by) {
            return slid(on.surface, on.boundary, here, by).point.position;
		};
		const Vec3f last = on.m().position[room.last], next = on.m().position[room.next];
		EXPECT_LT(length(end(-room.backward) - last), 1e-5f);
		EXPECT_LT(length(end(room.forward) - next), 1e-5f);
		EXPECT_GT(dot(slideDirection(on.boundary, here, room), next - last), 0.0f);
	}
}

TEST(SlideRoom, IsNoneForPinnedVerticesAndInside)
{
	OnSurface on(grid(8, 8));
	const int side = vertexAt(on, {0.5, 0, 0}), inside = vertexAt(on, {0.5, 0.5, 0});
	on.result.vertex[side].isPinned = true;
	EXPECT_FALSE(slideRoom(on.result, on.boundary, side).isOpen());
	EXPECT_FALSE(slideRoom(on.result, on.boundary, inside).isOpen());
}

/// A slide away from the corner of a square would cut the corner off.
TEST(SlideKeepsToCurve, OnAStraightSideButNotAtItsEnd)
{
	OnSurface  on(grid(8, 8));
	const auto slides = [&](int v) {
		const SlideRoom room = slideRoom(on.result, on.boundary, v);
		return slideKeepsToCurve(on.result, on.boundary, v, room, 0.5f * room.forward);
	};
	const int side = vertexAt(on, {0.5, 0, 0}), corner = vertexAt(on, {0, 0, 0});
	EXPECT_TRUE(slides(side));
	EXPECT_TRUE(mayLeaveCurve(on.result, on.boundary, side));
	EXPECT_FALSE(slides(corner));
	EXPECT_FALSE(mayLeaveCurve(on.result, on.boundary, corner));
}

} // namespace

} // namespace gpr::test
