// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/split_edges.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/base/angle.h>
#include <vcg_extras/core/features/crease_lines.h>
#include <vcg_extras/core/features/feature_detection.h>
#include <vcg_extras/core/features/given_lines.h>
#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

class MarkCreases : public ::testing::Test {
protected:
	Workers        workers{2, nullptr};
	Surface        surface;
	CreaseRules    rules;
	CreaseFindings found;

	void mark(const TriangleMesh& mesh)
	{
		surface = surfaceOf(mesh, workers);
		markOnSurface();
	}

	/// Marks after splits of all edges longer than a share of the mean.
	void markSplit(const TriangleMesh& mesh, float share)
	{
		IndexedMesh indexed   = loaded(mesh, workers);
		rules.callersMeanEdge = meanEdgeLength(indexed, workers);
		ASSERT_GT(splitLongEdges(indexed, share * rules.callersMeanEdge, 1000000, workers), 0);
		surface = surfaceOf(std::move(indexed), workers);
		markOnSurface();
	}

	void markOnSurface()
	{
		found = markCreases(rules, workers, surface);
		EXPECT_EQ(surface.mesh.hasCreases(), found.edgeNum > 0);
		std::int64_t marked = 0;
		for (int h = 0; h < surface.mesh.halfEdgeNum(); ++h) {
			if (!surface.mesh.isCreaseEdge(h)) continue;
			++marked;
			ASSERT_GE(surface.mesh.opposite[h], 0);
			EXPECT_TRUE(surface.mesh.isCreaseEdge(surface.mesh.opposite[h])) << "both halves";
		}
		EXPECT_EQ(marked, 2 * found.edgeNum);
	}
	Vec3d place(int v) const { return surface.frame.toCaller(surface.mesh.position[v]); }
	/// The number of vertices with `creaseNum` crease edges.
	int vertexNumWith(int creaseNum) const
	{
		int n = 0;
		for (int v = 0; v < surface.mesh.vertexNum; ++v)
			n += surface.mesh.isCreaseVertex(v) && surface.mesh.creaseNum(v) == creaseNum;
		return n;
	}
	double markedLength() const
	{
		double sum = 0;
		for (int h = 0; h < surface.mesh.halfEdgeNum(); ++h) {
			if (!surface.mesh.isCreaseEdge(h)) continue;
			sum += 0.5 * length(place(surface.mesh.target(h)) - place(surface.mesh.origin[h]));
		}
		return sum;
	}
};

TEST_F(MarkCreases, TheTwelveEdgesOfACube)
{
	mark(cube(8));
	EXPECT_EQ(found.edgeNum, 12 * 8);
	EXPECT_EQ(vertexNumWith(3), 8);
	EXPECT_EQ(vertexNumWith(2), 12 * 7);
	EXPECT_TRUE(found.coneApexes.empty());
	EXPECT_NEAR(markedLength(), 12, 1e-6);
}

/// A cube of twelve triangles: every face has two creases.
TEST_F(MarkCreases, TheCoarsestCubeIsNoNoise)
{
	mark(cube(1));
	EXPECT_EQ(found.edgeNum, 12);
}

TEST_F(MarkCreases, TheConcaveEdgeOfAnLToo)
{
	mark(lPrism(6));
	EXPECT_EQ(vertexNumWith(3), 12);
	EXPECT_NEAR(markedLength(), 2 * 8 + 6, 1e-6);
}

/// Rims of a length of 1.9 each, and of smooth surroundings.
TEST_F(MarkCreases, ShortLoopsMayStayWhereShortLinesMayNot)
{
	const TriangleMesh rims = closedCylinder(24, 12, 0.3, 1);
	surface                 = surfaceOf(rims, workers);
	const float scale       = float(surface.frame.scale);
	rules.minLength         = 3 * scale;
	rules.minLoop           = 1.5f * scale;
	mark(rims);
	EXPECT_EQ(found.edgeNum, 2 * 24);
	rules.minLoop = 2 * scale;
	mark(rims);
	EXPECT_EQ(found.edgeNum, 0);
}

TEST_F(MarkCreases, ShortLinesWithEndsGoWhateverLoopsMay)
{
	const TriangleMesh fading = fadingCrease(16, 1.5);
	mark(fading);
	ASSERT_GT(found.edgeNum, 0);
	rules.minLength = 100 * float(surface.frame.scale);
	mark(fading);
	EXPECT_EQ(found.edgeNum, 0);
}

/// The twelve edges of a box, of length 12 in all, and without a free end.
TEST_F(MarkCreases, TellHowMuchLongerLinesMayHaveToBe)
{
	const TriangleMesh cube  = gpr::test::box(4, 4, 4, {1, 1, 1});
	surface                  = surfaceOf(cube, workers);
	const float scale        = float(surface.frame.scale);
	const auto  edgeNumAfter = [&](int doublings) {
        rules.minLength = 5 * scale;
        rules.minLoop   = scale;
        for (int i = 0; i < doublings; ++i) {
            rules.minLength *= 2;
            rules.minLoop *= 2;
        }
        mark(cube);
        return found.edgeNum;
	};
	ASSERT_EQ(edgeNumAfter(0), 12 * 4);
	const int spare = found.spareDoublings;
	EXPECT_EQ(spare, 3) << "1 · 8 < 12 < 1 · 16";
	EXPECT_EQ(edgeNumAfter(spare), 12 * 4);
	EXPECT_EQ(edgeNumAfter(spare + 1), 0);
}

TEST_F(MarkCreases, TwoThatCross)
{
	mark(crossedCreases(20, 0.6));
	EXPECT_EQ(vertexNumWith(4), 1);
	EXPECT_EQ(vertexNumWith(1), 4) << "where they meet the border";
	EXPECT_EQ(found.edgeNum, 2 * 20);
}

TEST_F(MarkCreases, TheTwoCirclesOfACylinder)
{
	mark(closedCylinder(64, 12, 0.5, 1));
	EXPECT_EQ(found.edgeNum, 2 * 64);
	EXPECT_EQ(vertexNumWith(2), 2 * 64);
}

/// The needles of the side make the mean edge as long as the circles.
TEST_F(MarkCreases, TheTwoCirclesOfALongPin)
{
	const TriangleMesh pin = closedCylinder(60, 1, 1, 20);
	mark(pin);
	EXPECT_EQ(found.edgeNum, 120);
	markSplit(pin, 0.2f);
	EXPECT_GE(found.edgeNum, 120);
}

TEST_F(MarkCreases, AThinPlateHasTwelveEdges)
{
	mark(thinPlate(30, 0.005));
	EXPECT_EQ(vertexNumWith(3), 8);
	EXPECT_NEAR(markedLength(), 8 + 4 * 0.005, 1e-6);
}

TEST_F(MarkCreases, TellCreasesTooShortForLines)
{
	rules.minLength = rules.minLoop = 100;
	mark(cube(4));
	EXPECT_EQ(found.edgeNum, 0);
	EXPECT_EQ(found.creaseNum, 12 * 4);
}

TEST_F(MarkCreases, NoneOnANoisySphere)
{
	Random             random(5);
	const TriangleMesh noisy = noisySphere(5, 0.02, random);
	mark(noisy);
	EXPECT_EQ(found.edgeNum, 0);
	EXPECT_TRUE(found.coneApexes.empty());
	EXPECT_EQ(found.creaseNum, 0);
	rules.mode = FeatureMode::Lines;
	mark(noisy);
	EXPECT_GT(found.edgeNum, 0) << "the test wants noise with sharp edges";
}

/// Splits make flat edges inside of faces; the noise must not stand out from these edges.
TEST_F(MarkCreases, NoneOnANoisySphereWhateverWasSplit)
{
	for (double amplitude : {0.02, 0.03, 0.04}) {
		for (float share : {1.2f, 0.7f, 0.3f, 0.15f}) {
			if (share > 1 && amplitude < 0.04) continue; // no edge is so long
			Random             random(5);
			const TriangleMesh noisy = noisySphere(4, amplitude, random);
			rules.mode               = FeatureMode::Auto;
			markSplit(noisy, share);
			EXPECT_EQ(found.edgeNum, 0) << amplitude << ", " << share;
			EXPECT_TRUE(found.coneApexes.empty()) << amplitude << ", " << share;
			rules.mode = FeatureMode::Lines;
			markSplit(noisy, share);
			EXPECT_GT(found.edgeNum, 0) << amplitude << ", " << share;
		}
	}
}

TEST_F(MarkCreases, ThoseOfCubesWhateverWasSplit)
{
	for (int n : {1, 4}) {
		markSplit(cube(n), 0.3f);
		EXPECT_EQ(vertexNumWith(3), 8) << n;
		EXPECT_NEAR(markedLength(), 12, 1e-5) << n;
	}
}

TEST_F(MarkCreases, NoneOnASmoothSphere)
{
	mark(icosphere(4));
	EXPECT_EQ(found.edgeNum, 0);
	EXPECT_TRUE(found.coneApexes.empty());
}

TEST_F(MarkCreases, NothingWhereItIsOff)
{
	rules.mode = FeatureMode::Off;
	mark(cube(4));
	EXPECT_EQ(found.edgeNum, 0);
}

TEST_F(MarkCreases, TheTipOfACone)
{
	mark(cone(60, 20, 0.5, 0.7));
	ASSERT_EQ(found.coneApexes.size(), 1u);
	EXPECT_NEAR(length(place(found.coneApexes[0])), 0, 1e-6);
	EXPECT_EQ(found.edgeNum, 0);
}

/// Each of the twelve tips of an icosahedron, of 60°, has five tips as neighbours.
TEST_F(MarkCreases, NoTipOfAPolyhedronIsThatOfACone)
{
	rules.strongDeg = 50;
	mark(icosphere(0));
	EXPECT_EQ(found.edgeNum, 0);
	EXPECT_TRUE(found.coneApexes.empty());
}

TEST_F(MarkCreases, FromTheAngleGivenOn)
{
	const double radians = 3.14159265358979 / 180;
	rules.mode           = FeatureMode::Lines;
	for (float angle : {20.0f, 40.0f, 90.0f, 150.0f}) {
		rules.strongDeg = angle + 2;
		rules.weakDeg   = 0.5f * rules.strongDeg;
		mark(bentSheet(16, double(angle) * radians));
		EXPECT_EQ(found.edgeNum, 0) << angle;
		rules.strongDeg = angle - 2;
		mark(bentSheet(16, double(angle) * radians));
		EXPECT_EQ(found.edgeNum, 16) << angle;
	}
}

/// Few vertices are looked at, and not by this angle: none may be missing.
TEST_F(MarkCreases, AllAreFoundOnNoiseOfAnyKind)
{
	rules.mode      = FeatureMode::Lines;
	rules.minLength = rules.minLoop = rules.minSpur = 0;
	int seed                                        = 0;
	for (double noise : {0.005, 0.02, 0.05}) {
		for (float angle : {25.0f, 30.5f, 31.0f, 40.0f, 75.0f}) {
			rules.strongDeg = rules.weakDeg = angle; // nothing grows
			Random random(++seed);
			mark(noisySphere(4, noise, random));
			const HalfEdgeMesh& m = surface.mesh;
			for (int h = 0; h < m.halfEdgeNum(); ++h) {
				const float between =
					angleBetween(m.faceCross(h / 3), m.faceCross(m.opposite[h] / 3));
				if (between < (angle + 0.01f) * float(radians)) continue;
				ASSERT_TRUE(m.isCreaseEdge(h)) << noise << ", " << angle;
			}
		}
	}
	EXPECT_GT(found.edgeNum, 0) << "the test wants noise with sharp edges";
}

/// 80° at the border, nothing at the other: the line goes on from 40° down to 20°.
TEST_F(MarkCreases, FadeOut)
{
	mark(fadingCrease(80, 80 * 3.14159265358979 / 180));
	ASSERT_GT(found.edgeNum, 0);
	double last = 0;
	for (int v = 0; v < surface.mesh.vertexNum; ++v) {
		if (!surface.mesh.isCreaseVertex(v)) continue;
		EXPECT_NEAR(place(v).x, 0.5, 1e-6);
		last = std::max(last, place(v).y);
	}
	EXPECT_NEAR(last, 0.75, 0.02);
	EXPECT_EQ(vertexNumWith(1), 2) << "one end at the border, one inside";
}

TEST_F(MarkCreases, LeavesOutWhatIsTooShort)
{
	rules.minLength = 30;
	mark(cube(8));
	EXPECT_EQ(found.edgeNum, 0);
}

/// The edges of a flat grid along x = 0.5 as given lines: one mark for each edge, on either face.
std::vector<std::uint8_t> middleLine(const TriangleMesh& mesh)
{
	std::vector<std::uint8_t> line(mesh.triangles.size(), 0);
	const auto                isOn = [&](std::size_t corner) {
        return std::abs(mesh.positions[mesh.triangles[corner]].x - 0.5) < 1e-9;
	};
	for (std::size_t c = 0; c < line.size(); ++c)
		line[c] = isOn(c) && isOn(c % 3 == 2 ? c - 2 : c + 1);
	return line;
}

TEST(GivenLines, AreMarkedWhereNothingIsSharp)
{
	Workers                         workers(2, nullptr);
	const TriangleMesh              mesh    = grid(20, 20);
	const std::vector<std::uint8_t> line    = middleLine(mesh);
	Surface                         surface = surfaceOf(mesh, workers);
	MeshView                        view    = mesh.view();
	EXPECT_EQ(markGivenLines(view, workers, surface), 0);
	view.line = line.data();
	EXPECT_EQ(markGivenLines(view, workers, surface), 20);
	for (int h = 0; h < surface.mesh.halfEdgeNum(); ++h) {
		if (!surface.mesh.isCreaseEdge(h)) continue;
		for (int v : {surface.mesh.origin[h], surface.mesh.target(h)})
			EXPECT_NEAR(surface.frame.toCaller(surface.mesh.position[v]).x, 0.5, 1e-6);
	}
}

/// FeatureMode::Given: only the given line, although all edges of the cube are sharp.
TEST(GivenLines, MayBeTheOnlyOnes)
{
	const TriangleMesh        mesh = cube(8);
	std::vector<std::uint8_t> line(mesh.triangles.size(), 0);
	RemeshOptions             options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = 150;
	options.featureMode     = FeatureMode::Given;
	EXPECT_EQ(remesh(mesh.view(), options).status, Status::BadOptions) << "none is given";
	MeshView view = mesh.view();
	view.line     = line.data();
	EXPECT_EQ(remesh(view, options).report.featureEdgeNum, 0);
	line[0]              = 1;
	const RemeshResult r = remesh(view, options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.report.featureEdgeNum, 1);
}

/// The whole way: edges of the result cover the line from border to border.
TEST(GivenLines, AreEdgesOfTheResult)
{
	const TriangleMesh              mesh = grid(60, 60);
	const std::vector<std::uint8_t> line = middleLine(mesh);
	RemeshOptions                   options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = 300;
	double covered[2]       = {0, 0};
	for (int given : {0, 1}) {
		MeshView view = mesh.view();
		if (given) view.line = line.data();
		const RemeshResult r = remesh(view, options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const HalfEdgeMesh m = halfEdgesOf(r.mesh);
		for (int h = 0; h < m.halfEdgeNum(); ++h) {
			const Vec3f a = m.position[m.origin[h]], b = m.position[m.target(h)];
			const bool  isOn = std::abs(a.x - 0.5f) < 1e-5f && std::abs(b.x - 0.5f) < 1e-5f;
			if (isOn) covered[given] += 0.5 * double(length(b - a));
		}
	}
	EXPECT_LT(covered[0], 0.5) << "or the test tells nothing";
	EXPECT_NEAR(covered[1], 1, 1e-4);
}

} // namespace

/// A whole run: for more vertices than the mesh has, a noisy mesh is split before the noise is
/// measured.
TEST(FeatureLines, FollowNoNoiseHoweverManyVerticesAreWanted)
{
	Random             random(5);
	const TriangleMesh mesh = noisySphere(4, 0.04, random);
	for (double percent : {10.0, 50.0, 150.0}) {
		RemeshOptions options;
		options.targetMode    = TargetMode::Percent;
		options.targetPercent = percent;
		const RemeshResult r  = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(r.report.featureEdgeNum, 0) << percent;
	}
}

} // namespace gpr::test
