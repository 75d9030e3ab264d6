// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of the page of a comparison.
#include "mesh_files.h"

#include <vcg_extras/viewer/base64.h>
#include <vcg_extras/viewer/shown_mesh.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace gpr_test {

using gpr::TriangleMesh;
using gpr::Vec3d;
using gpr::app::ShownFrame;
using gpr::app::ShownMesh;
using gpr::app::shownMesh;

namespace {

TriangleMesh asMesh(const TestMesh& mesh)
{
	TriangleMesh out;
	for (const auto& p : mesh.points)
		out.positions.push_back({p[0], p[1], p[2]});
	for (const auto& f : mesh.faces)
		out.triangles.insert(out.triangles.end(), f.begin(), f.end());
	return out;
}

Vec3d corner(const ShownMesh& shown, std::size_t c)
{
	const float* const p = &shown.positions[3 * shown.triangles[c]];
	return {double(p[0]), double(p[1]), double(p[2])};
}

} // namespace

TEST(ShownMesh, IsTheMeshInTheFrameWhereItIsSmall)
{
	const TriangleMesh mesh = asMesh(moved(sphere(8), 100, 0, -50));
	const ShownFrame   frame(mesh.view());
	const ShownMesh    shown = shownMesh(mesh.view(), frame, mesh.faceNum());
	ASSERT_EQ(shown.faceOf.size(), mesh.faceNum());
	const double diagonal = 2 * std::sqrt(3.0);
	for (std::size_t c = 0; c < shown.triangles.size(); ++c) {
		const Vec3d p = mesh.positions[std::size_t(mesh.triangles[c])] - Vec3d(100, 0, -50);
		EXPECT_LT(length(corner(shown, c) - p * (1 / diagonal)), 1e-6);
		EXPECT_EQ(shown.faceOf[c / 3], c / 3);
	}
}

TEST(ShownMesh, HasAtMostTheTrianglesThatAreAllowedAndManyOfThem)
{
	const TriangleMesh mesh = asMesh(sphere(60)); // 28,800 faces
	const ShownFrame   frame(mesh.view());
	for (const std::size_t most : {20000u, 5000u, 300u}) {
		const ShownMesh shown = shownMesh(mesh.view(), frame, most);
		EXPECT_LE(shown.faceOf.size(), most);
		EXPECT_GT(shown.faceOf.size(), most / 5);
		// Means of points of the sphere are inside, at most by the size of a cell.
		const double radius = 1 / (2 * std::sqrt(3.0));
		for (std::size_t c = 0; c < shown.triangles.size(); ++c) {
			EXPECT_LT(length(corner(shown, c)), radius + 1e-6);
			EXPECT_GT(length(corner(shown, c)), radius - 2 / std::sqrt(double(most)));
		}
		// No triangle is drawn with two equal corners, and each shows another face.
		for (std::size_t c = 0; c < shown.triangles.size(); c += 3)
			EXPECT_EQ(std::set<std::uint32_t>(&shown.triangles[c], &shown.triangles[c] + 3).size(),
					  3u);
		EXPECT_EQ(std::set<std::uint32_t>(shown.faceOf.begin(), shown.faceOf.end()).size(),
				  shown.faceOf.size());
	}
}

TEST(ShownMesh, LeavesOutFacesWithoutPlace)
{
	TriangleMesh mesh     = asMesh(sphere(4));
	const auto   whole    = std::uint32_t(mesh.faceNum());
	const double infinite = std::numeric_limits<double>::infinity();
	mesh.positions.push_back({0, infinite, 0});
	mesh.positions.push_back({1e30, 0, 0}); // in no face
	mesh.triangles.insert(mesh.triangles.end(), {0, 1, std::int32_t(mesh.positions.size()) - 2});
	mesh.triangles.insert(mesh.triangles.end(), {0, 0, 1});
	const ShownFrame frame(mesh.view());
	EXPECT_NEAR(frame.scale, 1 / (2 * std::sqrt(3.0)), 1e-12);
	for (const std::size_t most : {1000u, 60u}) {
		const ShownMesh shown = shownMesh(mesh.view(), frame, most);
		EXPECT_GT(shown.faceOf.size(), 0u);
		for (const std::uint32_t f : shown.faceOf)
			EXPECT_LT(f, whole);
		for (const float x : shown.positions)
			EXPECT_TRUE(std::isfinite(x));
	}
}

TEST(ShownMesh, OfNothingIsNothing)
{
	const TriangleMesh mesh;
	EXPECT_TRUE(shownMesh(mesh.view(), ShownFrame(mesh.view()), 10).triangles.empty());
}

// The examples of RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard)
{
	using gpr::app::base64;
	EXPECT_EQ(base64(""), "");
	EXPECT_EQ(base64("f"), "Zg==");
	EXPECT_EQ(base64("fo"), "Zm8=");
	EXPECT_EQ(base64("foo"), "Zm9v");
	EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
	EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

} // namespace gpr_test
