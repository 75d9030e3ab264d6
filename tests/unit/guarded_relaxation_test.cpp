// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which single flip or slide is allowed: each rule of relaxGuarded by itself.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/guard/guarded_relaxation.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace gpr::test {

namespace {

/// The largest distances allowed are a tenth of this.
constexpr double wideEdge = 100;

/// Two triangles with the common edge from a to b, and c and d at the sides.
GuardedMesh quad(const std::array<Vec3d, 4>& at)
{
	return GuardedMesh(halfEdgesOf({{at[0], at[1], at[2], at[3]}, {0, 1, 2, 1, 0, 3}}), false);
}

/// Whether the edge from a to b is flipped.
bool flips(GuardedMesh g, double idealEdge = wideEdge)
{
	Workers workers(1, nullptr);
	relaxGuarded(idealEdge, false, g, workers);
	return g.mesh.findHalfEdge(2, 3) >= 0 || g.mesh.findHalfEdge(3, 2) >= 0;
}

/// A ridge from a to b, four units long, with slopes down by `depth` on both sides.
std::array<Vec3d, 4> ridge(double depth, double a = -2, double b = 2)
{
	return {{{a, 0, 0}, {b, 0, 0}, {0, 1, -depth}, {0, -1, -depth}}};
}

/// A needle between a and b, whose third corner lies a hundredth of `by` beside a.
std::array<Vec3d, 4> needle(const Vec3d& by)
{
	const Vec3d a(-2, 0, 0);
	return {{a, {2, 0, 0}, a + by * 0.01, {0, -1, 0}}};
}

} // namespace

TEST(GuardedFlip, MakesTheWorseShapeBetter)
{
	EXPECT_TRUE(flips(quad(ridge(0))));
	EXPECT_FALSE(flips(quad(ridge(0, -0.5, 0.5))));
}

TEST(GuardedFlip, IsMadeOnlyOnce)
{
	Workers            workers(1, nullptr);
	GuardedMesh        g(halfEdgesOf(lattice(6, 6)), false);
	const TriangleMesh before = meshOf(g.mesh);
	relaxGuarded(wideEdge, false, g, workers);
	EXPECT_EQ(meshOf(g.mesh).triangles, before.triangles) << "all are equilateral";
	EXPECT_FALSE(flips(quad({{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}})))
		<< "both diagonals are as good";
}

TEST(GuardedFlip, LeavesEdgesFarFromEachOther)
{
	EXPECT_TRUE(flips(quad(ridge(0.2)), 4));
	EXPECT_FALSE(flips(quad(ridge(0.2)), 1));
}

TEST(GuardedFlip, LeavesEdgesThatWouldGetSharp)
{
	EXPECT_TRUE(flips(quad(ridge(0.1, -0.4, 4))));
	EXPECT_FALSE(flips(quad(ridge(0.33, -0.4, 4)))) << "37 degrees would be 44";
}

TEST(GuardedFlip, LeavesSharpEdgesWhereTheyWouldStaySharp)
{
	EXPECT_TRUE(flips(quad(ridge(0.6)))) << "62 degrees come to 33";
	EXPECT_FALSE(flips(quad(ridge(0.85)))) << "81 degrees would be 46";
}

/// The normal of a needle has no meaning, so edges of needles are not sharp.
TEST(GuardedFlip, DoesNotTakeEdgesOfNeedlesForSharp)
{
	EXPECT_TRUE(flips(quad(needle({-0.85, 1, 0.5})))) << "the new edge has 44 degrees";
	EXPECT_FALSE(flips(quad(needle({-0.9, 0.8, 0.5})))) << "a face would turn by 58 degrees";
}

TEST(GuardedFlip, IsRefusedAgainstAssignedNormals)
{
	GuardedMesh g = quad(ridge(0.1));
	for (GuardedVertex& v : g.vertex)
		v.normal = v.normal * -1.0f;
	EXPECT_FALSE(flips(std::move(g)));
}

TEST(GuardedFlip, LeavesFixedFaces)
{
	GuardedMesh g = quad(ridge(0));
	for (int v : {0, 1, 2})
		g.vertex[std::size_t(v)].isFixed = true;
	EXPECT_FALSE(flips(std::move(g)));
	GuardedMesh other = quad(ridge(0));
	for (int v : {0, 2, 3})
		other.vertex[std::size_t(v)].isFixed = true;
	EXPECT_TRUE(flips(std::move(other)));
}

/// The point lies a little below a face, and farther below the faces after a flip.
TEST(GuardedFlip, LeavesPointsAsNear)
{
	const std::array<Vec3d, 4> shallow = ridge(0.05);
	EXPECT_TRUE(flips(quad(shallow), 1));
	GuardedMesh g = quad(shallow);
	g.vertex[2].points.push_back({0, 0.33f, 0.08f});
	EXPECT_FALSE(flips(std::move(g), 1));
}

namespace {

/// A vertex inside a ring of fixed vertices; the first slide leads to `goal`.
class Hub {
public:
	GuardedMesh guarded;

	Hub(const std::vector<Vec3d>& hubAndRing, const Vec3d& goal) :
			guarded(halfEdgesOf(fanOf(hubAndRing)), false), from_(guarded.mesh.position[0])
	{
		for (GuardedVertex& v : guarded.vertex)
			v.isFixed = true;
		guarded.vertex[0].isFixed = false;
		guarded.vertex[0].quadric = Quadric();
		// The faces' barycentre draws with a tenth of a quadric's trace, here of three.
		guarded.vertex[0].quadric.addPoint(goal + (goal - barycentre()) * 0.3, 1);
	}

	/// Sets normals without meaning.
	void forgetNormals()
	{
		for (GuardedVertex& v : guarded.vertex)
			v.normal = Vec3f();
	}

	bool moves(double idealEdge = wideEdge)
	{
		Workers workers(1, nullptr);
		relaxGuarded(idealEdge, true, guarded, workers);
		return !(at() == from_);
	}
	Vec3f at() const { return guarded.mesh.position[0]; }

private:
	Vec3f from_;

	Vec3d barycentre() const
	{
		Vec3d  sum;
		double area = 0;
		for (int f = 0; f < guarded.mesh.faceNum; ++f) {
			const double here = double(length(guarded.mesh.faceCross(f)));
			sum += Vec3d(guarded.mesh.faceCentre(f)) * here;
			area += here;
		}
		return sum * (1 / area);
	}

	static TriangleMesh fanOf(const std::vector<Vec3d>& hubAndRing)
	{
		TriangleMesh fan;
		fan.positions  = hubAndRing;
		const int last = int(hubAndRing.size()) - 1;
		for (int v = 1; v <= last; ++v)
			fan.triangles.insert(fan.triangles.end(), {0, v, v < last ? v + 1 : 1});
		return fan;
	}
};

/// A vertex a little above the middle of a side of a ring.
std::vector<Vec3d> aboveASide(double height)
{
	return {{0, 0, height}, {0, 1, 0}, {-2, 1, 0}, {-2, -1, 0}, {0, -1, 0}};
}

/// The normal of this side's face before; with a foot a little inside, the face turns upwards.
const Vec3f sideways(1, 0, 0);

} // namespace

TEST(GuardedSlide, MakesShapesBetter)
{
	const auto hexagon = [](const Vec3d& hub) {
		std::vector<Vec3d> points = {hub};
		for (int k = 0; k < 6; ++k)
			points.emplace_back(std::cos(k * 1.0472), std::sin(k * 1.0472), 0);
		return points;
	};
	EXPECT_TRUE(Hub(hexagon({0.2, 0, 0}), {0, 0, 0}).moves());
	EXPECT_FALSE(Hub(hexagon({0, 0, 0}), {0.2, 0, 0}).moves()) << "all are equilateral";
}

/// Without assigned points, only the planes hold the vertex.
TEST(GuardedSlide, StaysNearThePlanes)
{
	const std::vector<Vec3d> bowl = {{1, 0, 0}, {5, 5, 2}, {-5, 5, 2}, {-5, -5, 2}, {5, -5, 2}};
	Hub                      hub(bowl, {0, 0, 0});
	hub.guarded.vertex[0].quadric = Quadric();
	hub.guarded.vertex[0].quadric.addPlane({0, 0, 0}, {0, 0, 1}, 1);
	hub.guarded.vertex[0].area = 1;
	hub.guarded.vertex[0].points.clear();
	EXPECT_TRUE(hub.moves(1));
	EXPECT_LE(std::abs(hub.at().z), 0.1f);
	EXPECT_GT(std::abs(hub.at().z), 0.05f) << "the others are above";
}

TEST(GuardedSlide, IsRefusedWhereAFaceTurns)
{
	for (const double height : {0.02, 0.5}) {
		Hub hub(aboveASide(height), {-0.6, 0, height});
		hub.forgetNormals();
		EXPECT_EQ(hub.moves(), height > 0.1) << height;
	}
}

TEST(GuardedSlide, IsRefusedWhereAFaceTurnsAgainstWhatItStandsFor)
{
	// Each step turns the side's face by 10 to 35 degrees; the assigned points look 72 degrees
	// away.
	const Vec3f wanted(0.309f, 0, -0.951f);
	for (const bool isAgainst : {false, true}) {
		Hub hub(aboveASide(0.02), {-0.037, 0, 0.02});
		hub.forgetNormals();
		for (int v : {1, 4}) {
			hub.guarded.vertex[std::size_t(v)].normal = isAgainst ? wanted : sideways;
			hub.guarded.vertex[std::size_t(v)].area   = 1;
		}
		hub.guarded.vertex[0].area = 0.01f;
		for (int v : {2, 3})
			hub.guarded.vertex[std::size_t(v)].area = 9;
		EXPECT_EQ(hub.moves(), !isAgainst);
	}
}

} // namespace gpr::test
