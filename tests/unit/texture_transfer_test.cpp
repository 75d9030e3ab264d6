// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <vcg_extras/core/carry_over.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/texture_transfer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gpr::test {

namespace {

/// The texture of a point of the unit square: two charts with a seam at x = 0.5.
std::array<double, 2> chartAt(const Vec3d& p, bool right)
{
	if (right) return {0.9 - 0.4 * p.y, 0.4 * p.x};
	return {0.4 * p.x, 0.5 + 0.4 * p.y};
}

/// Corner textures of two charts.
CornerTexture twoCharts(const TriangleMesh& mesh)
{
	CornerTexture texture;
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
		const bool right = middleOf(mesh, c / 3).x > 0.5;
		const auto uv    = chartAt(mesh.positions[std::size_t(mesh.triangles[c])], right);
		texture.uv.push_back(float(uv[0]));
		texture.uv.push_back(float(uv[1]));
	}
	return texture;
}

RemeshResult remeshed(const MeshView& view, std::int64_t vertexNum)
{
	RemeshOptions options;
	options.targetMode           = TargetMode::VertexNum;
	options.targetVertexNum      = vertexNum;
	options.surfacePointsOfFaces = true;
	options.threads              = 2;
	return remesh(view, options);
}

/// Largest distance of the texture at a face's corners from the texture of the side of the face's
/// middle.
double largestMiss(const TriangleMesh& mesh, const CornerTexture& carried)
{
	double largest = 0;
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
		const bool right = middleOf(mesh, c / 3).x > 0.5;
		const auto uv    = chartAt(mesh.positions[std::size_t(mesh.triangles[c])], right);
		largest          = std::max({largest, std::abs(uv[0] - double(carried.uv[2 * c])),
									 std::abs(uv[1] - double(carried.uv[2 * c + 1]))});
	}
	return largest;
}

TEST(TextureTransfer, SeamsAreWhereTheSidesDiffer)
{
	const TriangleMesh  mesh = grid(20, 20);
	const TextureSource source(mesh.view(), twoCharts(mesh));
	EXPECT_EQ(std::count(source.seams().begin(), source.seams().end(), 1), 2 * 20);
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
		if (!source.seams()[c]) continue;
		EXPECT_EQ(mesh.positions[std::size_t(mesh.triangles[c])].x, 0.5);
	}
}

TEST(TextureTransfer, AVertexTwiceAtAPlaceIsNoSeam)
{
	Random             random(3);
	const TriangleMesh soup = soupOf(grid(6, 6), 0, random);
	CornerTexture      texture;
	for (const std::int32_t v : soup.triangles) {
		texture.uv.push_back(float(soup.positions[std::size_t(v)].x));
		texture.uv.push_back(float(soup.positions[std::size_t(v)].y));
	}
	EXPECT_FALSE(TextureSource(soup.view(), texture).hasSeams());
}

TEST(TextureTransfer, SeamsAreFollowedAndTheTextureExact)
{
	const TriangleMesh  mesh = grid(40, 40);
	const TextureSource source(mesh.view(), twoCharts(mesh));
	MeshView            view = mesh.view();
	view.line                = source.seams().data();
	const RemeshResult r     = remeshed(view, 200);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	for (std::size_t c = 0; c < r.mesh.triangles.size(); ++c) {
		const double x    = r.mesh.positions[std::size_t(r.mesh.triangles[c])].x;
		const double side = middleOf(r.mesh, c / 3).x - 0.5;
		EXPECT_GE((x - 0.5) * (side > 0 ? 1 : -1), -1e-6) << "a face lies across the seam";
	}
	EXPECT_LT(largestMiss(r.mesh, source.carriedTo(r)), 1e-5);
}

TEST(TextureTransfer, FacesAcrossASeamGetTheTextureOfTheirMiddlesSide)
{
	const TriangleMesh  mesh = grid(40, 40);
	const TextureSource source(mesh.view(), twoCharts(mesh));
	const RemeshResult  r = remeshed(mesh.view(), 200); // without lines
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	const CornerTexture carried = source.carriedTo(r);
	// A corner across the seam gets the texture of the nearest point, at most an edge away.
	const double edge = r.report.quality.meanEdgeLen;
	EXPECT_LT(largestMiss(r.mesh, carried), 0.4 * 1.3 * edge);
	// The charts are farther apart.
	EXPECT_GT(std::abs(chartAt({0.5, 0.3, 0}, false)[0] - chartAt({0.5, 0.3, 0}, true)[0]),
			  0.4 * 1.3 * edge);
}

TEST(TextureTransfer, AChartThatMeetsItselfHasASeamToo)
{
	const TriangleMesh mesh = openCylinder(60, 30, 1, 2);
	CornerTexture      texture;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const Vec3d  m      = middleOf(mesh, f);
		const double around = std::atan2(m.y, m.x);
		for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
			const Vec3d p = mesh.positions[std::size_t(mesh.triangles[c])];
			double      u = std::atan2(p.y, p.x);
			if (u - around > M_PI) u -= 2 * M_PI;
			if (around - u > M_PI) u += 2 * M_PI;
			texture.uv.push_back(float(u / (2 * M_PI)));
			texture.uv.push_back(float(p.z / 2));
		}
	}
	const TextureSource source(mesh.view(), texture);
	ASSERT_TRUE(source.hasSeams());
	for (bool lines : {true, false}) {
		MeshView view = mesh.view();
		if (lines) view.line = source.seams().data();
		const RemeshResult r = remeshed(view, 300);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const CornerTexture carried = source.carriedTo(r);
		for (std::size_t f = 0; f < r.mesh.faceNum(); ++f) {
			for (std::size_t k = 0; k < 3; ++k) {
				const float du = carried.uv[6 * f + 2 * k] - carried.uv[6 * f];
				EXPECT_LT(std::abs(du), 0.2) << "a face spans the seam";
			}
		}
	}
}

TEST(PointVector, AreLeftOutWhereNobodyAsksAndChangeNothing)
{
	const TriangleMesh mesh = grid(30, 30);
	RemeshOptions      options;
	options.targetMode              = TargetMode::VertexNum;
	options.targetVertexNum         = 100;
	const RemeshResult with         = remesh(mesh.view(), options);
	options.surfacePointsOfVertices = false;
	const RemeshResult without      = remesh(mesh.view(), options);
	ASSERT_EQ(with.status, Status::Ok);
	ASSERT_EQ(without.status, Status::Ok);
	EXPECT_EQ(with.surfacePoints.size(), 100u);
	EXPECT_TRUE(without.surfacePoints.empty());
	EXPECT_EQ(with.mesh.triangles, without.mesh.triangles);
	EXPECT_EQ(with.mesh.positions, without.mesh.positions);
	// Kept vertices are named in any case.
	options.boundary        = BoundaryMode::Keep;
	options.targetVertexNum = 300;
	const RemeshResult kept = remesh(mesh.view(), options);
	ASSERT_EQ(kept.status, Status::Ok) << kept.message;
	EXPECT_EQ(kept.callersVertex.size(), kept.mesh.positions.size());
}

TEST(CarryOver, MeansAreRoundedAndNaNsWithoutWeightLeftOut)
{
	const double           nan   = std::numeric_limits<double>::quiet_NaN();
	const double           at[3] = {3, 5, nan};
	const BarycentricPoint point{0, {0.25f, 0.75f, 0}};
	EXPECT_EQ(meanOfCorners(point, [&](int k) { return at[k]; }), 4.5);
	EXPECT_EQ(nearestCorner(point), 1);
	EXPECT_EQ(meanAs<unsigned char>(254.6), 255);
	EXPECT_EQ(meanAs<unsigned char>(300), 255);
	EXPECT_EQ(meanAs<signed char>(-300), -128);
	EXPECT_EQ(meanAs<float>(0.25), 0.25f);
}

TEST(CarryOver, ConstantsStayThoughFloatWeightsHaveAnotherSum)
{
	const double           at[3] = {1, 2, 6};
	const BarycentricPoint third{0, {0.25f, 0.25f, 0.25f}};
	EXPECT_EQ(meanOfCorners(third, [&](int k) { return at[k]; }), 3);
	const BarycentricPoint point{0, {0.208510995f, 0.498592407f, 0.292896599f}}; // rounds .1 off
	for (const double constant : {5.4e6, 0.1, -1e300, std::numeric_limits<double>::infinity()})
		EXPECT_EQ(meanOfCorners(point, [&](int) { return constant; }), constant);
}

} // namespace

} // namespace gpr::test
