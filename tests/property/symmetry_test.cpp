// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric results.
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/run_options.h>
#include <vcg_extras/core/prepared_surface.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace gpr::test {

namespace {

RemeshOptions symmetric(Symmetry symmetry, std::int64_t vertexNum)
{
	RemeshOptions options = countOptions(vertexNum);
	options.symmetry      = symmetry;
	options.threads       = 2;
	return options;
}

RemeshResult remeshed(const TriangleMesh& mesh, const RemeshOptions& options)
{
	const RemeshResult result = remesh(mesh.view(), options);
	EXPECT_EQ(result.status, Status::Ok) << result.message;
	EXPECT_TRUE(isSoundSurface(result.mesh));
	EXPECT_TRUE(hasSameTopology(result.mesh, mesh));
	return result;
}

TriangleMesh movedBy(TriangleMesh mesh, const Vec3d& by)
{
	for (Vec3d& p : mesh.positions)
		p += by;
	return mesh;
}

/// The coordinates as floats, as in a file.
std::array<float, 3> floatsOf(const Vec3d& p)
{
	return {float(p.x), float(p.y), float(p.z)};
}

std::array<float, 3> imageOf(const Vec3d& p, int axis, double at)
{
	Vec3d q = p;
	setCoordinate(q, axis, 2 * at - coordinate(p, axis));
	return floatsOf(q);
}

/// For each vertex its mirror image; -1 without an image, bit for bit.
std::vector<std::int32_t> imagesOf(const TriangleMesh& mesh, int axis, double at)
{
	std::map<std::array<float, 3>, std::int32_t> named;
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v)
		named[floatsOf(mesh.positions[v])] = std::int32_t(v);
	std::vector<std::int32_t> images;
	for (const Vec3d& p : mesh.positions) {
		const auto found = named.find(imageOf(p, axis, at));
		images.push_back(found == named.end() ? -1 : found->second);
	}
	return images;
}

using Face = std::array<std::int32_t, 3>;

Face turned(Face f)
{
	std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
	return f;
}

/// Every vertex and every face has its mirror image, and no edge crosses the plane.
void expectSymmetric(const TriangleMesh& mesh, int axis, double at)
{
	const std::vector<std::int32_t> images = imagesOf(mesh, axis, at);
	ASSERT_EQ(std::count(images.begin(), images.end(), -1), 0);
	std::set<Face> faces, mirrored;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const std::int32_t* c = &mesh.triangles[3 * f];
		faces.insert(turned({c[0], c[1], c[2]}));
		mirrored.insert(turned(
			{images[std::size_t(c[0])], images[std::size_t(c[2])], images[std::size_t(c[1])]}));
		const auto height = [&](int k) {
			return coordinate(mesh.positions[std::size_t(c[k])], axis) - at;
		};
		for (int k = 0; k < 3; ++k)
			EXPECT_GE(height(k) * height((k + 1) % 3), 0) << "an edge crosses the plane";
	}
	EXPECT_EQ(faces, mirrored);
}

TEST(Symmetry, EachVertexHasItsImageBitForBit)
{
	const TriangleMesh mesh = torus(60, 30);
	for (const Symmetry symmetry : {Symmetry::X, Symmetry::Y, Symmetry::Z}) {
		for (const int num : {200, 301}) {
			const RemeshResult result = remeshed(mesh, symmetric(symmetry, num));
			EXPECT_EQ(int(result.mesh.vertexNum()), num);
			expectSymmetric(result.mesh, int(symmetry) - int(Symmetry::X), 0);
		}
	}
}

TEST(Symmetry, PlanesBesideTheOriginKeepTheBitsOfFloats)
{
	const RemeshResult result =
		remeshed(movedBy(torus(61, 31), {17.3, -4.1, 2.7}), symmetric(Symmetry::X, 250));
	double low = HUGE_VAL, high = -HUGE_VAL;
	for (const Vec3d& p : result.mesh.positions) {
		low  = std::min(low, p.x);
		high = std::max(high, p.x);
		EXPECT_EQ(double(float(p.x)), p.x);
	}
	expectSymmetric(result.mesh, 0, 0.5 * (low + high));
}

TEST(Symmetry, FeatureLinesBordersAndRegionsAreCarried)
{
	TriangleMesh              mesh = movedBy(box(12, 8, 6, {3, 2, 1}), {-1.5, 0, 0});
	std::vector<std::int32_t> region;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const Vec3d p = middleOf(mesh, f);
		region.push_back(std::abs(p.x) > 0.75 ? (p.x > 0 ? 3 : 4) : 5);
	}
	MeshView view                = mesh.view();
	view.region                  = region.data();
	RemeshOptions options        = symmetric(Symmetry::X, 400);
	options.surfacePointsOfFaces = true;
	const RemeshResult result    = remesh(view, options);
	ASSERT_EQ(result.status, Status::Ok) << result.message;
	expectSymmetric(result.mesh, 0, 0);
	double area = 0;
	for (std::size_t f = 0; f < result.mesh.faceNum(); ++f) {
		const Vec3d p = middleOf(result.mesh, f);
		EXPECT_EQ(result.region[f], std::abs(p.x) > 0.75 ? (p.x > 0 ? 3 : 4) : 5);
		EXPECT_GE(result.facePoints[f].face, 0);
		const std::int32_t* c  = &result.mesh.triangles[3 * f];
		const auto          at = [&](int k) { return result.mesh.positions[std::size_t(c[k])]; };
		area += 0.5 * length(cross(at(1) - at(0), at(2) - at(0)));
	}
	EXPECT_NEAR(area, 22, 0.01); // edges of the box are kept
}

TEST(Symmetry, ImagesTakeTheValuesOfTheirOwnSide)
{
	const TriangleMesh mesh   = torus(60, 30);
	const RemeshResult result = remeshed(mesh, symmetric(Symmetry::X, 200));
	for (std::size_t v = 0; v < result.mesh.vertexNum(); ++v) {
		const BarycentricPoint& at = result.surfacePoints[v];
		Vec3d                   p;
		for (int k = 0; k < 3; ++k)
			p += mesh.positions[std::size_t(mesh.triangles[std::size_t(3 * at.face + k)])] *
				 double(at.weight[k]);
		EXPECT_LT(length(p - result.mesh.positions[v]), 0.05);
	}
}

TEST(Symmetry, OpenSurfacesGetTheirCounts)
{
	const TriangleMesh mesh = movedBy(grid(24, 16, 3, 2), {-1.5, 0, 0});
	for (const int num : {150, 151, 152}) {
		const RemeshResult result = remeshed(mesh, symmetric(Symmetry::X, num));
		EXPECT_EQ(int(result.mesh.vertexNum()), num);
		expectSymmetric(result.mesh, 0, 0);
	}
	RemeshOptions faces = symmetric(Symmetry::X, 0);
	faces.targetMode    = TargetMode::FaceNum;
	faces.targetFaceNum = 300;
	EXPECT_EQ(int(remeshed(mesh, faces).mesh.faceNum()), 300);
	faces.targetFaceNum        = 301;
	const RemeshResult refused = remesh(mesh.view(), faces);
	EXPECT_EQ(refused.status, Status::PromiseBroken);
	EXPECT_NE(refused.message.find("300 and 302"), std::string::npos) << refused.message;
}

TEST(Symmetry, FewVerticesAreHadOrRefused)
{
	const TriangleMesh mesh = icosphere(3);
	for (int num = 1; num <= 12; ++num) {
		const RemeshResult result = remesh(mesh.view(), symmetric(Symmetry::Z, num));
		if (num >= 5) {
			ASSERT_EQ(result.status, Status::Ok) << result.message;
			EXPECT_EQ(int(result.mesh.vertexNum()), num);
			EXPECT_TRUE(isSoundSurface(result.mesh));
			expectSymmetric(result.mesh, 2, 0);
		}
		else {
			EXPECT_EQ(result.status, Status::CountTooSmall) << result.message;
			EXPECT_GE(result.smallestVertexNum, 5);
		}
	}
}

/// A cylinder without its ends, round the z axis. width: of its radius along x.
TriangleMesh tube(double width)
{
	constexpr int around = 48, along = 25;
	TriangleMesh  mesh;
	for (int j = 0; j < along; ++j) {
		for (int i = 0; i < around; ++i) {
			const double turn = 2 * 3.141592653589793 * i / around;
			mesh.positions.push_back(
				{width * std::cos(turn), std::sin(turn), 2.0 * j / (along - 1)});
		}
	}
	for (std::int32_t v = 0; v + around < std::int32_t(mesh.vertexNum()); ++v) {
		const std::int32_t next = v % around + 1 < around ? v + 1 : v + 1 - around;
		for (const std::int32_t w : {v, next, next + around, v, next + around, v + around})
			mesh.triangles.push_back(w);
	}
	return mesh;
}

/// The guard makes the half anew, and its new vertices on the plane lie on no curve. The count that
/// follows splits edges between such vertices.
TEST(Symmetry, HalvesMadeAnewAreCountedOn)
{
	const TriangleMesh mesh = torus(16, 8);
	for (const Symmetry symmetry : {Symmetry::X, Symmetry::Y, Symmetry::Z}) {
		for (int num = 12; num <= 20; ++num) {
			const RemeshResult result = remesh(mesh.view(), symmetric(symmetry, num));
			if (result.status == Status::CountTooSmall) continue;
			ASSERT_EQ(result.status, Status::Ok) << result.message;
			expectSymmetric(result.mesh, int(symmetry) - int(Symmetry::X), 0);
		}
	}
}

/// The figures and the note are of the mesh after the count that follows on the guard.
TEST(Symmetry, HalvesMadeAnewAreToldOf)
{
	const TriangleMesh mesh    = torus(16, 8);
	int                madeNum = 0;
	for (int num = 12; num <= 20; ++num) {
		const RemeshResult    result  = remesh(mesh.view(), symmetric(Symmetry::Y, num));
		const GuardedFigures& guarded = result.report.audit.guarded;
		if (result.status != Status::Ok || guarded.vertexNum == 0) continue;
		++madeNum;
		EXPECT_LE(guarded.vertexNum, num);
		EXPECT_GT(guarded.foundPairNum, 0);
		const std::string told =
			"made " + std::to_string(guarded.vertexNum) + " of the " + std::to_string(num);
		const auto tells = [&](const std::string& note) {
			return note.find(told) != std::string::npos;
		};
		EXPECT_TRUE(std::any_of(result.notes.begin(), result.notes.end(), tells)) << told;
	}
	EXPECT_GT(madeNum, 0);
}

/// With few vertices, an open border of the half could have no vertex off the plane.
TEST(Symmetry, TubesWithFewVerticesStayOpen)
{
	for (const double width : {1.0, 0.05}) {
		const TriangleMesh mesh = tube(width);
		for (int num = 5; num <= 16; ++num) {
			const RemeshResult result = remesh(mesh.view(), symmetric(Symmetry::X, num));
			EXPECT_EQ(result.status, num < 8 ? Status::CountTooSmall : Status::Ok)
				<< num << result.message;
			if (result.status != Status::Ok) continue;
			EXPECT_EQ(int(result.mesh.vertexNum()), num);
			EXPECT_TRUE(hasSameTopology(result.mesh, mesh));
			expectSymmetric(result.mesh, 0, 0);
		}
	}
}

TEST(Symmetry, HalvesThatDoNotTouchThePlaneAreTwo)
{
	TriangleMesh       mesh  = movedBy(icosphere(3), {1.02, 0, 0});
	const std::int32_t first = std::int32_t(mesh.vertexNum());
	const std::size_t  num   = mesh.triangles.size();
	for (std::int32_t v = 0; v < first; ++v) {
		const Vec3d p = mesh.positions[std::size_t(v)];
		mesh.positions.push_back({-p.x, p.y, p.z});
	}
	for (std::size_t c = 0; c < num; c += 3)
		for (int k : {0, 2, 1})
			mesh.triangles.push_back(first + mesh.triangles[c + std::size_t(k)]);
	const RemeshResult result = remeshed(mesh, symmetric(Symmetry::X, 24));
	EXPECT_EQ(int(result.mesh.vertexNum()), 24);
	expectSymmetric(result.mesh, 0, 0);
	const RemeshResult odd = remesh(mesh.view(), symmetric(Symmetry::X, 25));
	EXPECT_EQ(odd.status, Status::PromiseBroken);
	EXPECT_NE(odd.message.find("24 and 26"), std::string::npos) << odd.message;
}

/// A thin rod along the plane: edges could join both borders of its half.
TEST(Symmetry, ThinPartsAlongThePlaneStayWhole)
{
	TriangleMesh rod = uvSphere(60, 24);
	for (Vec3d& p : rod.positions)
		p = {0.06 * p.x, 0.06 * p.y, 2 * p.z};
	const RemeshResult result = remeshed(rod, symmetric(Symmetry::X, 300));
	EXPECT_EQ(int(result.mesh.vertexNum()), 300);
	expectSymmetric(result.mesh, 0, 0);
}

TEST(Symmetry, WhatIsNotSymmetricIsRefused)
{
	TriangleMesh mesh = torus(60, 30);
	for (Vec3d& p : mesh.positions)
		p.x += 0.2 * p.y * p.y + 0.05 * p.y;
	const RemeshResult refused = remesh(mesh.view(), symmetric(Symmetry::X, 200));
	EXPECT_EQ(refused.status, Status::UnusableInput);
	EXPECT_NE(refused.message.find("% of the diagonal"), std::string::npos) << refused.message;
	const RemeshResult found = remeshed(mesh, symmetric(Symmetry::Auto, 200));
	expectSymmetric(found.mesh, 2, 0); // the only plane of symmetry
}

TEST(Symmetry, AutoFindsAPlaneThatLiesAcrossNoAxis)
{
	TriangleMesh mesh = torus(60, 30);
	const double c = std::cos(0.4), s = std::sin(0.4);
	for (Vec3d& p : mesh.positions) {
		p = {1.3 * p.x, p.y, p.z * (1 + 0.2 * p.x)};
		p = {c * p.x - s * p.z, p.y, s * p.x + c * p.z};
		p = {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
	}
	const RemeshResult result = remeshed(mesh, symmetric(Symmetry::Auto, 200));
	EXPECT_EQ(int(result.mesh.vertexNum()), 200);
}

/// The plane of a flat sheet has no sides.
TEST(Symmetry, AutoTakesNoPlaneThatHoldsTheWholeSurface)
{
	TriangleMesh sheet = grid(30, 30);
	for (Vec3d& p : sheet.positions)
		p = {double(float(p.x * 0.7)), double(float(p.y * 1.1)), 0};
	EXPECT_EQ(remeshed(sheet, symmetric(Symmetry::Auto, 100)).mesh.vertexNum(), 100u);
}

TEST(Symmetry, ProgressNeverRunsBackwards)
{
	const TriangleMesh  mesh    = torus(300, 120);
	RemeshOptions       options = symmetric(Symmetry::Z, 4000);
	std::vector<double> shares;
	options.check   = true;
	const auto note = [&](double share, const char*) {
		shares.push_back(share);
		return true;
	};
	EXPECT_EQ(remesh(mesh.view(), options, note).status, Status::Ok);
	EXPECT_GT(shares.size(), 5u);
	EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

TEST(Symmetry, PreparedSurfacesGiveTheSameBytes)
{
	const TriangleMesh  mesh    = torus(60, 30);
	const RemeshOptions options = symmetric(Symmetry::Y, 200);
	PreparedSurface     prepared(mesh.view());
	const RemeshResult  plain = remesh(mesh.view(), options), kept = prepared.remesh(options);
	EXPECT_EQ(plain.mesh.positions, kept.mesh.positions);
	EXPECT_EQ(plain.mesh.triangles, kept.mesh.triangles);
}

TEST(Symmetry, LargestErrorsHoldForBothHalves)
{
	RemeshOptions options     = symmetric(Symmetry::X, 0);
	options.targetMode        = TargetMode::MaxError;
	options.targetMaxError    = 0.01;
	const RemeshResult result = remeshed(torus(60, 30), options);
	EXPECT_TRUE(result.report.isDistanceProven);
	EXPECT_LE(result.report.provenDistance.hausdorff().upper, 0.01);
	char proven[40];
	std::snprintf(proven, sizeof proven, "at most %.4g (%.3g %% of",
				  result.report.provenDistance.hausdorff().upper,
				  100 * result.report.provenDistance.hausdorff().upper /
					  result.report.input.diagonal);
	const auto tells = [&](const char* part) {
		return std::count_if(
			result.notes.begin(), result.notes.end(),
			[&](const std::string& note) { return note.find(part) != std::string::npos; });
	};
	EXPECT_EQ(tells(proven), 1) << "of the whole";
	EXPECT_EQ(tells("is proven to be"), 1);
	expectSymmetric(result.mesh, 0, 0);
}

} // namespace

} // namespace gpr::test
