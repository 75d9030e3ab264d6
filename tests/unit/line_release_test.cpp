// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Feature lines too close to each other for good angles are released if many angles are poor.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <tests/support/oracles.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/optimization/line_release.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

namespace gpr::test {

namespace {

constexpr int   cells    = 20;
constexpr float angleDeg = 32;

/// A flat square of squares; narrowNum columns in the middle have a quarter of the width.
TriangleMesh gridWithNarrowColumns(int narrowNum)
{
	TriangleMesh mesh  = grid(cells, cells);
	const int    first = (cells - narrowNum) / 2, last = first + narrowNum;
	for (Vec3d& p : mesh.positions) {
		const double column = p.x * cells;
		const double narrow = std::clamp(column, double(first), double(last)) - first;
		p.x                 = (column - 0.75 * narrow) / cells;
	}
	return mesh;
}

/// The faces of the narrow columns have angles of 14°. Every line of the grid along y is a feature
/// line.
struct Stripes : OnSurface {
	explicit Stripes(int narrowNum) : OnSurface(gridWithNarrowColumns(narrowNum))
	{
		m().crease = Buffer<char>(m().halfEdgeNum(), 0);
		for (int h = 0; h < m().halfEdgeNum(); ++h) {
			const float across = m().position[m().origin[h]].x - m().position[m().target(h)].x;
			m().crease[h]      = m().opposite[h] >= 0 && std::abs(across) < 1e-6f;
		}
		for (int v = 0; v < m().vertexNum; ++v) {
			if (m().isCreaseVertex(v) && !m().isBorderVertex(v)) result.vertex[v].curve = 7;
		}
	}
};

/// Inner vertices on a curve.
std::vector<int> onLines(const OnSurface& on)
{
	std::vector<int> vertices;
	for (int v = 0; v < on.result.mesh.vertexNum; ++v) {
		const bool isInner = !on.result.mesh.isBorderVertex(v);
		if (isInner && on.result.vertex[v].curve >= 0) vertices.push_back(v);
	}
	return vertices;
}

std::int64_t markNum(const OnSurface& on)
{
	const Buffer<char>& crease = on.result.mesh.crease;
	return std::count(crease.begin(), crease.end(), char(1));
}

} // namespace

/// Two narrow columns of twenty: three lines at poor faces, and two more on either side within two
/// rings.
TEST(ReleaseLines, FreesTheVerticesWithinTwoRingsAndNoOthers)
{
	Stripes      on(2);
	const auto   before = onLines(on);
	const auto   marks  = markNum(on);
	const int    inside = cells - 1;
	TriangleMesh shape  = meshOf(on.m());
	ASSERT_EQ(int(before.size()), inside * inside);
	EXPECT_EQ(releaseLines(angleDeg, on.result, on.workers), 7 * inside);
	EXPECT_EQ(int(onLines(on).size()), (inside - 7) * inside);
	EXPECT_EQ(marks - markNum(on), 7 * cells * 2);
	for (int v : before) {
		const bool isCreaseVertex = on.m().isCreaseVertex(v);
		EXPECT_EQ(on.result.vertex[v].curve >= 0, isCreaseVertex) << v;
	}
	EXPECT_TRUE(meshOf(on.m()).positions == shape.positions) << "only marks change";
	on.expectSound();
}

TEST(ReleaseLines, LeavesBordersAlone)
{
	Stripes                 on(2);
	const std::vector<char> corner = [&] {
		std::vector<char> is;
		for (const ResultVertex& v : on.result.vertex)
			is.push_back(v.isCorner);
		return is;
	}();
	ASSERT_GT(releaseLines(angleDeg, on.result, on.workers), 0);
	for (int v = 0; v < on.m().vertexNum; ++v) {
		if (!on.m().isBorderVertex(v)) continue;
		EXPECT_GE(on.result.vertex[v].curve, 0) << v;
		EXPECT_EQ(on.result.vertex[v].isCorner, corner[v] != 0) << v;
	}
}

/// The line through a pinned vertex stays: without a mark on its edges the vertex could move
/// freely.
TEST(ReleaseLines, LeavesPinnedVerticesOnTheirLine)
{
	Stripes unpinned(2), on(2);
	ASSERT_GT(releaseLines(angleDeg, unpinned.result, unpinned.workers), 0);
	std::vector<int> released;
	for (int v : onLines(on)) {
		if (unpinned.result.vertex[v].curve < 0) released.push_back(v);
	}
	const int pinned = released[released.size() / 2];

	on.result.vertex[pinned].isPinned = on.result.vertex[pinned].isCorner = true;
	ASSERT_GT(releaseLines(angleDeg, on.result, on.workers), 0);
	EXPECT_EQ(on.result.vertex[pinned].curve, 7);
	EXPECT_TRUE(on.result.vertex[pinned].isCorner);
	EXPECT_EQ(on.m().creaseNum(pinned), 2);
}

/// A plate as thin as a tenth of an edge would be rounded off without the lines of its rim. Only
/// the four upright edges at its corners are released.
TEST(ReleaseLines, LeavesTheLinesOfAThinWall)
{
	OnSurface     on(thinPlate(cells, 0.1 / cells));
	HalfEdgeMesh& m = on.m();
	m.crease        = Buffer<char>(m.halfEdgeNum(), 0);
	for (int h = 0; h < m.halfEdgeNum(); ++h)
		m.crease[h] = dot(m.faceNormal(h / 3), m.faceNormal(m.opposite[h] / 3)) < 0.5f;
	const auto marks = markNum(on);
	ASSERT_EQ(marks, 2 * (8 * cells + 4));
	releaseLines(angleDeg, on.result, on.workers);
	EXPECT_EQ(markNum(on), marks - 2 * 4);
}

TEST(ReleaseLines, FreesCorners)
{
	Stripes    on(2);
	const auto before = onLines(on);
	for (int v : before)
		on.result.vertex[v].isCorner = true;
	ASSERT_GT(releaseLines(angleDeg, on.result, on.workers), 0);
	for (int v : before)
		EXPECT_EQ(on.result.vertex[v].isCorner, on.m().isCreaseVertex(v)) << v;
}

/// A twentieth of the faces at lines is poor, then a tenth, then a third.
TEST(AreLinesCrowded, WhereManyButNotMostAnglesArePoor)
{
	for (int narrowNum : {0, 1, 2, 4, 7}) {
		Stripes on(narrowNum);
		EXPECT_EQ(areLinesCrowded(angleDeg, on.result, on.workers),
				  narrowNum == 2 || narrowNum == 4)
			<< narrowNum;
	}
	Stripes withoutLines(4);
	withoutLines.m().crease.release();
	EXPECT_FALSE(areLinesCrowded(angleDeg, withoutLines.result, withoutLines.workers));
}

/// Poor faces at no line are no reason to let lines go.
TEST(ReleaseLines, LooksAtLinesOnly)
{
	Stripes on(2);
	for (int h = 0; h < on.m().halfEdgeNum(); ++h) {
		const float x      = on.m().position[on.m().origin[h]].x;
		const float middle = on.m().position[0].x; // a corner of the square
		if (std::abs(x - middle) > 0.2f * on.surface.frame.scale) on.m().crease[h] = 0;
	}
	EXPECT_EQ(releaseLines(angleDeg, on.result, on.workers), 0);
}

TEST(ReleaseLines, DoesNotDependOnThreads)
{
	Stripes    one(3);
	const auto num = releaseLines(angleDeg, one.result, one.workers);
	ASSERT_GT(num, 0);
	for (int threads : {1, 3, 8}) {
		Stripes on(3);
		Workers workers(threads, nullptr);
		EXPECT_EQ(releaseLines(angleDeg, on.result, workers), num) << threads;
		EXPECT_TRUE(std::equal(on.m().crease.begin(), on.m().crease.end(), one.m().crease.begin()))
			<< threads;
	}
}

// ---- the whole way

namespace {

/// A square, folded up and down in the middle: foldNum steep strips, `width` wide on the ground.
TriangleMesh pleatedSheet(int foldNum, double width)
{
	const int    n     = int(std::lround(1 / width));
	const int    first = (n - foldNum) / 2;
	TriangleMesh mesh  = grid(n, n);
	for (Vec3d& p : mesh.positions) {
		const int fold = int(std::lround(p.x * n)) - first;
		if (fold > 0 && fold < foldNum && fold % 2 == 1) p.z = width;
	}
	return mesh;
}

/// A square with folds nearer to each other than a third of an edge, and a square with few folds.
TriangleMesh crowdedAndSparsePleats()
{
	return joined(pleatedSheet(5, 0.01), shifted(pleatedSheet(8, 0.125), {2, 0, 0}));
}

RemeshResult remeshed(const MeshView& view, int threads = 2)
{
	RemeshOptions options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = 700;
	options.threads         = threads;
	return remesh(view, options);
}

/// A single line edge at a corner of the mesh, far from all folds.
std::vector<std::uint8_t> oneLine(const TriangleMesh& mesh)
{
	std::vector<std::uint8_t> line(mesh.triangles.size(), 0);
	line[2] = 1;
	return line;
}

} // namespace

TEST(CrowdedLines, AreReleasedSoThatNoAngleIsPoor)
{
	const TriangleMesh mesh = crowdedAndSparsePleats();
	const RemeshResult r    = remeshed(mesh.view());
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_GT(r.report.releasedVertexNum, 30);
	EXPECT_GT(r.report.quality.minAngleDeg, 30);
	EXPECT_EQ(r.mesh.vertexNum(), 700u);
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
	ASSERT_FALSE(r.notes.empty());
	EXPECT_NE(r.notes.back().find("feature lines are too close"), std::string::npos);
}

/// Without a release a tenth of the faces has poor angles, which also shows the use of a release.
TEST(CrowdedLines, StayWhereTheCallerGaveLines)
{
	const TriangleMesh              mesh = crowdedAndSparsePleats();
	const std::vector<std::uint8_t> line = oneLine(mesh);
	MeshView                        view = mesh.view();
	view.line                            = line.data();
	const RemeshResult r                 = remeshed(view);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.report.releasedVertexNum, 0);
	EXPECT_GT(r.report.quality.below30Percent, 5);
}

/// Folds far from each other stay sharp from border to border, up to a fifth of an edge, although
/// some faces at these folds are poor before the fit.
TEST(CrowdedLines, LeaveTheOthersSharp)
{
	const TriangleMesh       mesh = crowdedAndSparsePleats();
	const RemeshResult       r    = remeshed(mesh.view());
	std::vector<Vec3d>       kept;
	const std::vector<Vec3d> all = sharpSegments(mesh, 40);
	for (const Vec3d& p : all) {
		if (p.x > 1.5) kept.push_back(p);
	}
	ASSERT_GT(kept.size(), 10u);
	ASSERT_GT(r.report.releasedVertexNum, 0);
	const double edge = r.report.quality.meanEdgeLen;
	EXPECT_LE(segmentDistance(kept, sharpSegments(r.mesh, 38)), 0.2 * edge);
}

/// Without their lines, many high folds would be cut off.
TEST(CrowdedLines, StayWhereTheSurfaceWouldBeLost)
{
	TriangleMesh mesh = pleatedSheet(16, 1.0 / 80);
	for (Vec3d& p : mesh.positions)
		p.z *= 2;
	mesh                 = joined(mesh, shifted(pleatedSheet(8, 0.125), {2, 0, 0}));
	const RemeshResult r = remeshed(mesh.view());
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.report.releasedVertexNum, 0);
	EXPECT_GT(r.report.quality.below30Percent, 1);
}

TEST(CrowdedLines, ThatOtherMeansMendStay)
{
	const TriangleMesh mesh = pleatedSheet(4, 1.0 / 60);
	const RemeshResult r    = remeshed(mesh.view());
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_GT(r.report.featureEdgeNum, 0);
	EXPECT_EQ(r.report.releasedVertexNum, 0);
	EXPECT_TRUE(r.notes.empty());
}

TEST(CrowdedLines, AreReleasedAlikeByAnyNumberOfThreads)
{
	const TriangleMesh mesh = crowdedAndSparsePleats();
	const RemeshResult one  = remeshed(mesh.view(), 1);
	ASSERT_GT(one.report.releasedVertexNum, 0);
	for (int threads : {2, 5}) {
		const RemeshResult r = remeshed(mesh.view(), threads);
		EXPECT_EQ(r.mesh.positions, one.mesh.positions) << threads;
		EXPECT_EQ(r.mesh.triangles, one.mesh.triangles) << threads;
	}
}

} // namespace gpr::test
