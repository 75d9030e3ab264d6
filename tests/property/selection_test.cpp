// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshing of the selected faces alone, and borders whose vertices stay.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/sampling/target.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace gpr::test {

namespace {

using Chosen = std::function<bool(const Vec3d& middle)>;

std::vector<std::uint8_t> selectionOf(const TriangleMesh& mesh, const Chosen& isChosen)
{
	std::vector<std::uint8_t> selected;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		Vec3d middle;
		for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
			middle += mesh.positions[std::size_t(mesh.triangles[c])] * (1 / 3.0);
		selected.push_back(isChosen(middle));
	}
	return selected;
}

RemeshOptions percent(double share)
{
	RemeshOptions options;
	options.targetMode    = TargetMode::Percent;
	options.targetPercent = share;
	options.threads       = 2;
	return options;
}

RemeshResult remeshSelection(const TriangleMesh& mesh, const std::vector<std::uint8_t>& selected,
							 const RemeshOptions& wanted)
{
	MeshView view        = mesh.view();
	view.selectedFace    = selected.data();
	RemeshOptions inside = wanted;
	inside.selectedOnly  = true;
	return remesh(view, inside);
}

/// The faces outside of the selection come first, with the same corners in the same places.
void expectRestUntouched(const TriangleMesh& mesh, const std::vector<std::uint8_t>& selected,
						 const RemeshResult& r)
{
	std::size_t next = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		if (selected[f]) continue;
		ASSERT_EQ(r.callersFace[next], std::int32_t(f));
		for (std::size_t k = 0; k < 3; ++k) {
			const Vec3d a = mesh.positions[std::size_t(mesh.triangles[3 * f + k])];
			const Vec3d b = r.mesh.positions[std::size_t(r.mesh.triangles[3 * next + k])];
			ASSERT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z);
		}
		++next;
	}
	EXPECT_EQ(r.report.untouchedFaceNum, std::int64_t(next));
	for (; next < r.mesh.faceNum(); ++next)
		ASSERT_EQ(r.callersFace[next], -1);
}

TEST(Selection, LeavesTheRestAloneAndJoinsIt)
{
	const TriangleMesh ball = icosphere(5), ring = torus(120, 60), sheet = grid(60, 60);
	const Chosen       half = [](const Vec3d& p) { return p.x > 0.1; };
	const Chosen spots = [](const Vec3d& p) { return std::sin(7 * p.x) * std::cos(6 * p.y) > 0.2; };
	const Chosen inside = [](const Vec3d& p) { return p.x > 0.3 && p.x < 0.7 && p.y > 0.3; };
	for (const auto& [mesh, isChosen] : {std::pair(&ball, &half), std::pair(&ring, &half),
										 std::pair(&ball, &spots), std::pair(&sheet, &inside)}) {
		const auto         selected = selectionOf(*mesh, *isChosen);
		const RemeshResult r        = remeshSelection(*mesh, selected, percent(40));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(*mesh, r.mesh));
		expectRestUntouched(*mesh, selected, r);
		EXPECT_LT(r.mesh.faceNum(), mesh->faceNum());
		EXPECT_EQ(r.report.input.diagonal, extentOf(mesh->view()).diagonal);
		EXPECT_EQ(r.surfacePoints.size(), r.mesh.vertexNum());
	}
}

TEST(Selection, CountsTheSelectedPart)
{
	const TriangleMesh mesh     = icosphere(5);
	const auto         selected = selectionOf(mesh, [](const Vec3d& p) { return p.z > 0; });
	RemeshOptions      options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = 1500;
	const RemeshResult r    = remeshSelection(mesh, selected, options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	std::set<std::int32_t> corners;
	for (std::size_t f = 0; f < r.mesh.faceNum(); ++f) {
		for (std::size_t c = 3 * f; r.callersFace[f] < 0 && c < 3 * f + 3; ++c)
			corners.insert(r.mesh.triangles[c]);
	}
	EXPECT_EQ(corners.size(), 1500u);
}

TEST(Selection, GrowsFromTheSeamWithGoodAngles)
{
	const TriangleMesh mesh     = icosphere(6);
	const auto         selected = selectionOf(mesh, [](const Vec3d& p) { return p.z > 0; });
	const RemeshResult r        = remeshSelection(mesh, selected, percent(15));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_GT(r.report.quality.radiusRatioMean, 0.93);
	EXPECT_LT(r.report.quality.below30Percent, 3);
}

TEST(Selection, IsRefusedWhereNothingIsSelected)
{
	const TriangleMesh mesh = icosphere(3);
	RemeshOptions      options;
	options.selectedOnly = true;
	EXPECT_EQ(remesh(mesh.view(), options).status, Status::BadOptions);
	const std::vector<std::uint8_t> none(mesh.faceNum(), 0);
	EXPECT_EQ(remeshSelection(mesh, none, percent(20)).status, Status::BadOptions);
}

/// A grid with a degenerate face, the last face: two faces, each along half of an edge of a third
/// face, meet the third face over the degenerate face.
TriangleMesh gridWithFaceWithoutArea()
{
	TriangleMesh mesh  = grid(12, 12);
	std::size_t  face  = 0;
	const auto   isFar = [&](std::size_t f) {
        const std::int32_t* t = &mesh.triangles[3 * f];
        return std::all_of(t, t + 3, [&](int v) {
            const Vec3d& p = mesh.positions[std::size_t(v)];
            return p.x > 0.7 && p.x < 0.9 && p.y > 0.2 && p.y < 0.8;
        });
	};
	while (!isFar(face))
		++face;
	const std::int32_t a = mesh.triangles[3 * face], b = mesh.triangles[3 * face + 1];
	const std::int32_t d = mesh.triangles[3 * face + 2], m = std::int32_t(mesh.vertexNum());
	mesh.positions.push_back((mesh.positions[std::size_t(a)] + mesh.positions[std::size_t(b)]) *
							 0.5);
	mesh.triangles[3 * face + 1] = m;
	mesh.triangles.insert(mesh.triangles.end(), {m, b, d, a, b, m});
	return mesh;
}

/// Without the degenerate face the mesh would be torn open.
TEST(Selection, LeavesAFaceWithoutAreaAtItsEdgeAsItIs)
{
	const TriangleMesh mesh = gridWithFaceWithoutArea();
	ASSERT_TRUE(factsOf(mesh).isManifold());
	std::vector<std::uint8_t> selected =
		selectionOf(mesh, [](const Vec3d& p) { return p.x < 0.5; });
	const std::vector<std::uint8_t> withoutIt = selected;
	selected.back()                           = 1;
	const RemeshResult r                      = remeshSelection(mesh, selected, percent(50));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
	expectRestUntouched(mesh, withoutIt, r);
}

/// A selected fan of faces along the line between the selection and the rest: within the selection
/// two faces meet at the edges of this line, so the line is no border of the selection.
TEST(Selection, IsRefusedWhereMoreThanTwoFacesMeetAtItsEdge)
{
	TriangleMesh       mesh     = grid(12, 12);
	const std::int32_t apex     = std::int32_t(mesh.vertexNum());
	const std::size_t  faceNum  = mesh.faceNum();
	const auto         isOnLine = [&](std::int32_t v) {
        const Vec3d& p = mesh.positions[std::size_t(v)];
        return p.x == 0.5 && p.y > 0.2 && p.y < 0.8;
	};
	std::vector<std::uint8_t> selected =
		selectionOf(mesh, [](const Vec3d& p) { return p.x < 0.5; });
	mesh.positions.push_back({0.8, 0.5, 0});
	for (std::size_t c = 0; c < 3 * faceNum; ++c) {
		const std::int32_t a = mesh.triangles[c], b = mesh.triangles[c % 3 == 2 ? c - 2 : c + 1];
		if (selected[c / 3] == 0 || !isOnLine(a) || !isOnLine(b)) continue;
		mesh.triangles.insert(mesh.triangles.end(), {b, a, apex});
		selected.push_back(1);
	}
	const RemeshResult r = remeshSelection(mesh, selected, percent(50));
	EXPECT_EQ(r.status, Status::PromiseBroken) << r.message;
	EXPECT_TRUE(r.mesh.triangles.empty());
}

TEST(Selection, OfEverythingIsTheWholeMesh)
{
	const TriangleMesh              mesh = icosphere(4);
	const std::vector<std::uint8_t> all(mesh.faceNum(), 1);
	const RemeshResult              r     = remeshSelection(mesh, all, percent(20));
	const RemeshResult              whole = remesh(mesh.view(), percent(20));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.mesh.triangles, whole.mesh.triangles);
}

/// Two balls that share a vertex: the run cuts the vertex, and the result has both parts.
TEST(Selection, CutsVerticesWithSeveralFansLikeARunOnTheWholeMesh)
{
	TriangleMesh       mesh  = icosphere(3);
	const std::int32_t first = std::int32_t(mesh.vertexNum());
	for (std::int32_t v = 1; v < first; ++v)
		mesh.positions.push_back(mesh.positions[0] * 2.0 - mesh.positions[std::size_t(v)]);
	for (std::size_t c = 0, num = mesh.triangles.size(); c < num; c += 3) {
		for (std::size_t k : {0u, 2u, 1u}) { // the mirror image, so turned
			const std::int32_t v = mesh.triangles[c + k];
			mesh.triangles.push_back(v == 0 ? 0 : first + v - 1);
		}
	}
	const std::vector<std::uint8_t> all(mesh.faceNum(), 1);
	const RemeshResult              r = remeshSelection(mesh, all, percent(20));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_EQ(r.report.result.vertices, std::int64_t(r.mesh.vertexNum()));
}

TEST(Selection, TellsThatItsBorderStays)
{
	const TriangleMesh mesh     = grid(30, 30);
	const auto         selected = selectionOf(mesh, [](const Vec3d& p) { return p.x > 0.5; });
	for (const BoundaryMode mode :
		 {BoundaryMode::Resample, BoundaryMode::Keep, BoundaryMode::Free, BoundaryMode::Smooth}) {
		RemeshOptions options       = percent(20);
		options.boundary            = mode;
		const RemeshResult r        = remeshSelection(mesh, selected, options);
		const bool         isWished = mode == BoundaryMode::Free || mode == BoundaryMode::Smooth;
		EXPECT_EQ(std::count(r.notes.begin(), r.notes.end(),
							 "The border mode has no effect: the border of selected faces stays."),
				  int(isWished));
	}
}

TEST(Selection, GivesTheSameWithAnyNumberOfThreads)
{
	const TriangleMesh mesh     = torus(90, 45);
	const auto         selected = selectionOf(mesh, [](const Vec3d& p) { return p.y > 0.05; });
	RemeshOptions      one = percent(30), three = percent(30);
	one.threads          = 1;
	three.threads        = 3;
	const RemeshResult a = remeshSelection(mesh, selected, one);
	const RemeshResult b = remeshSelection(mesh, selected, three);
	ASSERT_EQ(a.status, Status::Ok) << a.message;
	EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
	for (std::size_t v = 0; v < a.mesh.vertexNum(); ++v)
		ASSERT_EQ(squaredLength(a.mesh.positions[v] - b.mesh.positions[v]), 0);
}

/// The vertices of a border, as their places.
std::set<std::array<double, 3>> borderOf(const TriangleMesh& mesh)
{
	std::map<std::pair<int, int>, int> sides;
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
		const int a = mesh.triangles[c], b = mesh.triangles[c % 3 == 2 ? c - 2 : c + 1];
		++sides[std::minmax(a, b)];
	}
	std::set<std::array<double, 3>> places;
	for (const auto& [edge, num] : sides) {
		if (num != 1) continue;
		for (int v : {edge.first, edge.second}) {
			const Vec3d p = mesh.positions[std::size_t(v)];
			places.insert({p.x, p.y, p.z});
		}
	}
	return places;
}

TEST(Boundary, KeepLeavesEveryVertexOfItAndAddsNone)
{
	Random random(5);
	for (const TriangleMesh& mesh : {grid(50, 50), openCylinder(80, 40, 1, 2), squareFrame(40, 12),
									 jitteredGrid(45, 0.3, random)}) {
		for (double share : {10.0, 120.0}) {
			SCOPED_TRACE(share);
			RemeshOptions options = percent(share);
			options.boundary      = BoundaryMode::Keep;
			const RemeshResult r  = remesh(mesh.view(), options);
			ASSERT_EQ(r.status, Status::Ok) << r.message;
			EXPECT_TRUE(isSoundSurface(r.mesh));
			EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
			EXPECT_EQ(borderOf(r.mesh), borderOf(mesh));
		}
	}
}

/// Errors in percent are of the diagonal of the whole mesh, also in the notes.
TEST(Selection, ErrorsAreSharesOfTheWholeDiagonal)
{
	const TriangleMesh        mesh = joined(icosphere(4), shifted(icosphere(4), {20, 0, 0}));
	std::vector<std::uint8_t> selected(mesh.faceNum(), 0);
	std::fill_n(selected.begin(), mesh.faceNum() / 2, std::uint8_t(1));
	RemeshOptions options = percent(20);
	options.targetMode    = TargetMode::Detail;
	options.targetDetail  = Detail::Fine;
	const RemeshResult r  = remeshSelection(mesh, selected, options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	char text[80];
	std::snprintf(text, sizeof text, "%.4g (%.3g %% of the diagonal)",
				  detailError(Detail::Fine) * r.report.input.diagonal,
				  100 * detailError(Detail::Fine));
	ASSERT_FALSE(r.notes.empty());
	EXPECT_NE(r.notes.front().find(text), std::string::npos) << r.notes.front();
}

/// Rounding is no more than a hundred-millionth of the box, which is much of a small triangle.
TEST(Boundary, KeepLeavesThatOfTinyTriangles)
{
	const TriangleMesh mesh =
		joined(grid(50, 50), shifted(scaled(grid(20, 20), 2e-4), {0.7123, 0.3, 0.1}));
	RemeshOptions options = percent(60);
	options.boundary      = BoundaryMode::Keep;
	const RemeshResult r  = remesh(mesh.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(borderOf(r.mesh), borderOf(mesh));
}

TEST(Boundary, FreeCutsCornersThatResampleKeeps)
{
	const TriangleMesh mesh      = grid(50, 50);
	const auto         cornersOf = [&](BoundaryMode mode) {
        RemeshOptions options  = percent(7);
        options.boundary       = mode;
        const RemeshResult r   = remesh(mesh.view(), options);
        int                num = 0;
        for (const Vec3d& p : r.mesh.positions)
            num += (p.x == 0 || p.x == 1) && (p.y == 0 || p.y == 1);
        EXPECT_TRUE(isSoundSurface(r.mesh));
        return num;
	};
	EXPECT_EQ(cornersOf(BoundaryMode::Resample), 4);
	EXPECT_LT(cornersOf(BoundaryMode::Free), 4);
}

} // namespace

} // namespace gpr::test
