// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which single collapse is allowed: each rule of decimateGuarded by itself.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/guard/cube_decimation.h>

#include <gtest/gtest.h>
#include <vector>

namespace gpr::test {

namespace {

/// Vertex 0 inside a ring of vertices, counter-clockwise seen from above.
TriangleMesh fanOf(const std::vector<Vec3d>& hubAndRing)
{
	TriangleMesh fan;
	fan.positions  = hubAndRing;
	const int last = int(hubAndRing.size()) - 1;
	for (int v = 1; v <= last; ++v)
		fan.triangles.insert(fan.triangles.end(), {0, v, v < last ? v + 1 : 1});
	return fan;
}

/// The mesh and a sphere far away, which adds vertices: with few vertices some bounds are dropped.
TriangleMesh among(const TriangleMesh& mesh)
{
	return joined(mesh, shifted(icosphere(2), {1000, 0, 0}));
}

/// A fan. Only its hub is not fixed, and only the edge to vertex 1 is short enough for a collapse.
class Fan {
public:
	GuardedMesh     guarded;
	GuardedSettings settings;

	explicit Fan(const std::vector<Vec3d>& hubAndRing, bool isAlone = false) :
			Fan(isAlone ? fanOf(hubAndRing) : among(fanOf(hubAndRing)))
	{
	}
	explicit Fan(const TriangleMesh& mesh) : guarded(halfEdgesOf(mesh), false)
	{
		for (GuardedVertex& v : guarded.vertex)
			v.isFixed = true;
		guarded.vertex[0].isFixed = false;
		settings.idealEdge        = 1;
		settings.longestEdge      = 1.01 * length(mesh.positions[1] - mesh.positions[0]);
	}

	/// Sets the mean normal of the assigned points of all vertices, and the area for each vertex.
	void setNormals(const Vec3f& normal, float area)
	{
		for (GuardedVertex& v : guarded.vertex) {
			v.normal = normal;
			v.area   = area;
		}
	}

	bool collapses()
	{
		Workers workers(1, nullptr);
		settings.targetNum = guarded.mesh.vertexNum - 1;
		return decimateGuarded(settings, guarded, workers);
	}
};

/// A square of side 2 with the vertex over its middle.
std::vector<Vec3d> pyramid(double height, double depth = 1)
{
	return {{0, 0, height}, {1, depth, 0}, {-1, depth, 0}, {-1, -depth, 0}, {1, -depth, 0}};
}

/// A vertex near a triangle with this height over its base.
std::vector<Vec3d> lowTriangle(double height, double above)
{
	return {{0, 0, above}, {-1, 0, 0}, {1, 0, 0}, {0, height, 0}};
}

/// The collapse to vertex 1 turns the two remaining faces by 15 degrees.
const std::vector<Vec3d> slope = {{0, 0, 0}, {-2, 0, 0}, {0, -3, 0}, {2, 0, 1}, {0, 3, 0}};
/// A direction at 77 degrees to the normal of the first remaining face, 92 after the collapse.
const Vec3f between(-0.806f, 0.585f, -0.145f);

} // namespace

TEST(GuardedCollapse, IsRefusedWhereAFaceTurns)
{
	EXPECT_TRUE(Fan(pyramid(20)).collapses());
	EXPECT_FALSE(Fan(pyramid(100)).collapses());
	EXPECT_TRUE(Fan(pyramid(100), true).collapses()) << "of few vertices any shape will do";
}

TEST(GuardedCollapse, IsRefusedWhereAFaceGetsTooNarrow)
{
	EXPECT_TRUE(Fan(lowTriangle(0.02, 0.5)).collapses());
	EXPECT_FALSE(Fan(lowTriangle(0.005, 0.2)).collapses());
}

TEST(GuardedCollapse, LeavesNarrowFacesAsNarrow)
{
	EXPECT_TRUE(Fan(pyramid(0, 0.001)).collapses());
}

TEST(GuardedCollapse, IsRefusedWhereAFaceComesToBeALine)
{
	EXPECT_FALSE(Fan({{0.3, 0, 0.2}, {0, 0, 0}, {0, -1, 0}, {0, 1, 0}}).collapses());
}

TEST(GuardedCollapse, IsRefusedWhereAFaceTurnsAgainstWhatItStandsFor)
{
	Fan steep(slope);
	steep.setNormals(between, length(between));
	EXPECT_FALSE(steep.collapses());
	Fan flat(slope);
	flat.setNormals({0, 0, 1}, 1);
	EXPECT_TRUE(flat.collapses());
}

TEST(GuardedCollapse, IsAllowedWhereFacesWereAgainstAssignedNormalsBefore)
{
	Fan fan(slope);
	fan.setNormals({0, 0, -1}, 1);
	EXPECT_TRUE(fan.collapses());
}

/// Round a thin rim the normals of both sides add up to next to nothing.
TEST(GuardedCollapse, DoesNotHeedNormalsThatCancelOut)
{
	Fan fan(slope);
	fan.setNormals(between, 5 * length(between));
	EXPECT_TRUE(fan.collapses());
}

TEST(GuardedCollapse, GivesAFaceWithoutAreaTheSideThatItStandsFor)
{
	const std::vector<Vec3d> flatFace = {{0, 0, 0}, {-0.5, 0, 0}, {0, -1, 0}, {0, 1, 0}};
	Fan                      right(flatFace), wrong(flatFace);
	right.setNormals({0, 0, 1}, 1);
	wrong.setNormals({0, 0, -1}, 1);
	EXPECT_TRUE(right.collapses());
	EXPECT_FALSE(wrong.collapses());
}

TEST(GuardedCollapse, LeavesLongerEdges)
{
	Fan fan(pyramid(0));
	fan.settings.longestEdge = 1;
	EXPECT_FALSE(fan.collapses());
	fan.settings.longestEdge = 1.5;
	EXPECT_TRUE(fan.collapses());
}

/// Planes without a preferred place would draw the merged vertex to the middle.
TEST(GuardedCollapse, LeavesABorderVertexWhereItIs)
{
	Fan fan({{0, 0, 0}, {0.5, 0, 0}, {0, 2, 0}, {-2, 0, 0}, {0, -2, 0}});
	for (GuardedVertex& v : fan.guarded.vertex)
		v.quadric = Quadric();
	fan.guarded.vertex[1].isFixed = false;
	ASSERT_TRUE(fan.collapses());
	EXPECT_TRUE(fan.guarded.mesh.position[0] == Vec3f(0.5f, 0, 0));
}

TEST(GuardedCollapse, LeavesAFixedVertexOfABorderWhereItIs)
{
	Fan fan({{0, 0, 0}, {2, 0.1, 0}, {2, 0.5, 0}, {-2, 1, 0}, {-2, -1, 0}});
	for (GuardedVertex& v : fan.guarded.vertex)
		v.quadric = Quadric();
	fan.guarded.vertex[0].isFixed = true;
	fan.guarded.vertex[1].isFixed = false;
	fan.settings.longestEdge      = 0.5;
	ASSERT_TRUE(fan.collapses());
	EXPECT_TRUE(fan.guarded.mesh.position[1] == Vec3f(2, 0.5f, 0));
}

namespace {

/// Two fans far from each other; both hubs may go, and the edges to vertex 1 of each are short.
struct TwoFans {
	GuardedMesh     guarded;
	GuardedSettings settings;
	Vec3f           first, second; ///< hubs

	TwoFans(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) :
			guarded(halfEdgesOf(among(joined(fanOf(a), shifted(fanOf(b), {100, 0, 0})))), false),
			first(guarded.mesh.position[0]), second(guarded.mesh.position[int(a.size())])
	{
		for (GuardedVertex& v : guarded.vertex)
			v.isFixed = true;
		guarded.vertex[0].isFixed = guarded.vertex[a.size()].isFixed = false;
		settings.idealEdge                                           = 1;
		settings.targetNum                                           = guarded.mesh.vertexNum - 1;
	}

	/// Whether the first hub is left and the second hub gone.
	bool leavesFirst()
	{
		Workers workers(1, nullptr);
		EXPECT_TRUE(decimateGuarded(settings, guarded, workers));
		bool isFirst = false, isSecond = false;
		for (int v = 0; v < guarded.mesh.vertexNum; ++v) {
			isFirst  = isFirst || guarded.mesh.position[v] == first;
			isSecond = isSecond || guarded.mesh.position[v] == second;
		}
		EXPECT_NE(isFirst, isSecond);
		return isFirst;
	}
};

std::vector<Vec3d> scaledBy(double factor, std::vector<Vec3d> points)
{
	for (Vec3d& p : points)
		p = p * factor;
	return points;
}

} // namespace

TEST(GuardedCollapse, TakesShortEdgesFirst)
{
	EXPECT_TRUE(TwoFans(pyramid(0), scaledBy(0.5, pyramid(0))).leavesFirst());
	EXPECT_FALSE(TwoFans(scaledBy(0.5, pyramid(0)), pyramid(0)).leavesFirst());
}

/// A small tip costs less than a large flat fan, but goes farther off than is allowed at first.
TEST(GuardedCollapse, TakesWhatStaysNearFirst)
{
	const std::vector<Vec3d> tip = scaledBy(0.1, pyramid(0.5)), flat = pyramid(0);
	EXPECT_TRUE(TwoFans(tip, flat).leavesFirst());
	EXPECT_FALSE(TwoFans(scaledBy(0.1, flat), flat).leavesFirst());
}

namespace {

/// Two triangles with a notch between in their border: the vertex at the bottom of the notch is not
/// fixed. An upright triangle may fill the notch; the hub of a flat fan far away may go, too.
struct Notch {
	GuardedMesh     guarded;
	GuardedSettings settings;
	const Vec3f     bottom{0, -0.5f, 0}, hub{50, 0, 0};

	explicit Notch(bool isBarred) : guarded(halfEdgesOf(make(isBarred)), false)
	{
		for (GuardedVertex& v : guarded.vertex)
			v.isFixed = true;
		for (int v = 0; v < guarded.mesh.vertexNum; ++v) {
			if (has(guarded.mesh.position[v])) guarded.vertex[std::size_t(v)].isFixed = false;
		}
		settings.idealEdge   = 1;
		settings.targetNum   = guarded.mesh.vertexNum - 1;
		settings.keepsBorder = true;
	}

	bool has(const Vec3f& p) const { return p == bottom || p == hub; }
	bool isThere(const Vec3f& p) const
	{
		for (int v = 0; v < guarded.mesh.vertexNum; ++v) {
			if (guarded.mesh.position[v] == p) return true;
		}
		return false;
	}

private:
	static TriangleMesh make(bool isBarred)
	{
		TriangleMesh mesh{{{-1, 0, 0}, {0, -2, 0}, {0, -0.5, 0}, {1, 0, 0}}, {0, 1, 2, 2, 1, 3}};
		mesh = joined(mesh, shifted(fanOf(pyramid(0)), {50, 0, 0}));
		if (isBarred)
			mesh = joined(mesh, {{{-0.1, -0.2, -1}, {0.1, -0.2, -1}, {0, -0.2, 1}}, {0, 1, 2}});
		return among(mesh);
	}
};

} // namespace

/// The other vertices of a kept border count as gone, and go in the end, even if faces touch then.
TEST(GuardedCollapse, LeavesOnlyFixedVerticesOfAKeptBorder)
{
	Workers workers(1, nullptr);
	for (const bool isBarred : {false, true}) {
		Notch notch(isBarred);
		EXPECT_TRUE(decimateGuarded(notch.settings, notch.guarded, workers));
		EXPECT_FALSE(notch.isThere(notch.bottom));
		EXPECT_TRUE(notch.isThere(notch.hub));
	}
	Notch notch(true);
	notch.settings.keepsBorder = false;
	EXPECT_TRUE(decimateGuarded(notch.settings, notch.guarded, workers));
	EXPECT_TRUE(notch.isThere(notch.bottom));
	EXPECT_FALSE(notch.isThere(notch.hub));
}

/// The edge between both border vertices lies inside.
TEST(GuardedCollapse, DoesNotMergeBordersAcrossANeck)
{
	const TriangleMesh neck{
		{{0, 0.1, 0}, {0, -0.1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}},
		{2, 3, 0, 3, 1, 0, 1, 4, 0, 4, 5, 0}};
	EXPECT_FALSE(Fan(among(neck)).collapses());
}

/// Its vertices are all on the border.
TEST(GuardedCollapse, DoesNotMergeBordersAcrossABand)
{
	Workers         workers(1, nullptr);
	TriangleMesh    band = openCylinder(40, 1, 1, 0.1);
	GuardedMesh     g(halfEdgesOf(band), false);
	GuardedSettings settings;
	settings.targetNum = 40;
	settings.idealEdge = 0.3;
	ASSERT_TRUE(decimateGuarded(settings, g, workers));
	for (int v = 0; v < g.mesh.vertexNum; ++v) {
		EXPECT_TRUE(g.mesh.isBorderVertex(v));
		EXPECT_NEAR(g.mesh.position[v].z, g.mesh.position[v].z < 0.05f ? 0 : 0.1, 1e-4);
	}
}

TEST(GuardedCollapse, LeavesLoopsOfThreeEdges)
{
	Workers            workers(1, nullptr);
	const TriangleMesh tube = openCylinder(6, 4, 1, 2);
	GuardedMesh        g(halfEdgesOf(tube), false);
	GuardedSettings    settings;
	settings.targetNum = 1;
	settings.idealEdge = 1;
	EXPECT_FALSE(decimateGuarded(settings, g, workers));
	EXPECT_TRUE(hasSameTopology(tube, meshOf(g.mesh)));
	EXPECT_EQ(g.mesh.vertexNum, 6);
}

TEST(GuardedMesh, StandsForBordersThatAreMarked)
{
	GuardedMesh      g(halfEdgesOf(grid(1, 1)), false);
	HalfEdgeMesh     other = halfEdgesOf(grid(1, 1));
	std::vector<int> name  = {0, 1, 2, 3};
	const Vec3d      inside(0.5, 0.5, 0);
	other.crease = Buffer<char>(std::size_t(other.halfEdgeNum()), 0);
	g.assign(other, name);
	for (const GuardedVertex& v : g.vertex)
		EXPECT_NEAR(v.quadric.at(inside), 0, 1e-12) << "cut edges hold nothing";
	for (int h = 0; h < other.halfEdgeNum(); ++h)
		other.crease[h] = char(other.isBorderEdge(h));
	g.assign(other, name);
	for (const GuardedVertex& v : g.vertex)
		EXPECT_GT(v.quadric.at(inside), 0.1);
}

TEST(Quadric, IsLowestWherePlanesMeet)
{
	Quadric     q;
	const Vec3d corner(1, 2, 3);
	for (const Vec3d& n : {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)})
		q.addPlane(corner, n, 2);
	EXPECT_NEAR(length(q.lowest({}) - corner), 0, 1e-9);
	EXPECT_NEAR(q.at(corner + Vec3d(3, 0, 4)), 2 * 25, 1e-9);
	q.addPoint(corner + Vec3d(1, 1, 1), 2);
	EXPECT_NEAR(length(q.lowest({}) - (corner + Vec3d(0.5, 0.5, 0.5))), 0, 1e-9);
}

/// Rounding leaves a determinant a little off zero.
TEST(Quadric, TakesTheOtherPlaceWhereItsPlanesLeaveAChoice)
{
	Random      random(1);
	const Vec3d otherwise(1, 2, 3);
	for (int i = 0; i < 100; ++i) {
		const auto direction = [&] {
			return normalized(
				Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
		};
		Quadric q;
		for (int plane = 0; plane < 2; ++plane)
			q.addPlane({random.between(-9, 9), 0, 0}, direction(), 1);
		EXPECT_TRUE(q.lowest(otherwise) == otherwise);
	}
}

} // namespace gpr::test
