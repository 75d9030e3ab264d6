// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Several meshes remeshed as a whole and taken apart again.
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <vcg_extras/io/mesh/joined_pieces.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <set>

namespace gpr_test {

namespace {

using namespace gpr;
using gpr::app::JoinedPieces;

using Place = std::array<double, 3>;

/// A quarter of a hilly ground, its faces upwards or downwards.
TriangleMesh quarter(int i, int j, bool isUpwards)
{
	const int    side = 20;
	TriangleMesh mesh;
	for (int a = 0; a <= side; ++a) {
		for (int b = 0; b <= side; ++b) {
			const double x = i + double(a) / side, y = j + double(b) / side;
			mesh.positions.push_back({x, y, 0.1 * std::sin(4 * x) * std::cos(3 * y)});
		}
	}
	for (int a = 0; a < side; ++a) {
		for (int b = 0; b < side; ++b) {
			std::int32_t k = a * (side + 1) + b, l = k + side + 1, m = k + 1;
			if (!isUpwards) std::swap(l, m);
			mesh.triangles.insert(mesh.triangles.end(), {k, l, k + side + 2, k, k + side + 2, m});
		}
	}
	return mesh;
}

std::set<Place> placesOf(const TriangleMesh& mesh)
{
	std::set<Place> places;
	for (const Vec3d& p : mesh.positions)
		places.insert({p.x, p.y, p.z});
	return places;
}

/// The mean height of the normals of the faces.
double upwards(const TriangleMesh& mesh)
{
	double sum = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const auto at = [&](std::size_t k) {
			return mesh.positions[std::size_t(mesh.triangles[3 * f + k])];
		};
		sum += cross(at(1) - at(0), at(2) - at(0)).z / 2;
	}
	return sum;
}

class FourQuarters : public testing::Test {
protected:
	FourQuarters()
	{
		for (int k = 0; k < 4; ++k)
			mesh.push_back(quarter(k / 2, k % 2, k != 2));
		for (const TriangleMesh& m : mesh)
			view.push_back(m.view());
	}

	RemeshResult remeshed(const JoinedPieces& joined) const
	{
		RemeshOptions options;
		options.targetMode           = TargetMode::VertexNum;
		options.targetVertexNum      = 400;
		options.surfacePointsOfFaces = true;
		return remesh(joined.view(), options);
	}

	std::vector<TriangleMesh> mesh;
	std::vector<MeshView>     view;
};

TEST_F(FourQuarters, HaveTheSameVerticesOnTheirSeams)
{
	const JoinedPieces joined(view);
	const RemeshResult whole = remeshed(joined);
	ASSERT_EQ(whole.status, Status::Ok) << whole.message;
	std::set<Place> all;
	std::size_t     seamNum = 0;
	for (std::size_t k = 0; k < 4; ++k) {
		const RemeshResult    part   = joined.ofPiece(whole, k);
		const std::set<Place> places = placesOf(part.mesh);
		EXPECT_TRUE(gpr::test::isSoundSurface(part.mesh));
		EXPECT_TRUE(gpr::test::hasSameTopology(part.mesh, mesh[k]));
		EXPECT_NEAR(upwards(part.mesh), k == 2 ? -1 : 1, 1e-3);
		for (const Place& p : places) {
			seamNum += p[0] == 1 || p[1] == 1;
			EXPECT_LE(std::abs(p[0] - double(k / 2) - 0.5), 0.5);
			EXPECT_LE(std::abs(p[1] - double(k % 2) - 0.5), 0.5);
		}
		all.insert(places.begin(), places.end());
	}
	EXPECT_EQ(all.size(), 400u);
	EXPECT_GT(seamNum, 70u); // each twice, the middle four times
}

TEST_F(FourQuarters, MayHaveAVertexThatIsNoPlace)
{
	mesh[1].positions.insert(mesh[1].positions.begin(), Vec3d(NAN, NAN, NAN));
	for (std::int32_t& v : mesh[1].triangles)
		++v;
	view[1] = mesh[1].view();
	const JoinedPieces joined(view);
	const RemeshResult whole = remeshed(joined);
	ASSERT_EQ(whole.status, Status::Ok) << whole.message;
	const RemeshResult part = joined.ofPiece(whole, 1);
	for (const BarycentricPoint& at : part.surfacePoints)
		EXPECT_LT(std::size_t(at.face), mesh[1].faceNum());
}

TEST_F(FourQuarters, HavePointsAndLabelsOfTheirOwn)
{
	std::vector<std::int32_t> label(mesh[1].faceNum());
	for (std::size_t f = 0; f < label.size(); ++f)
		label[f] = f < label.size() / 2 ? 7 : 3;
	view[1].region = label.data();
	const JoinedPieces joined(view);
	const RemeshResult whole = remeshed(joined);
	ASSERT_EQ(whole.status, Status::Ok) << whole.message;
	for (std::size_t k = 0; k < 4; ++k) {
		const RemeshResult part = joined.ofPiece(whole, k);
		ASSERT_EQ(part.surfacePoints.size(), part.mesh.vertexNum());
		for (std::size_t v = 0; v < part.mesh.vertexNum(); ++v) {
			const BarycentricPoint& at = part.surfacePoints[v];
			ASSERT_LT(std::size_t(at.face), mesh[k].faceNum());
			Vec3d p;
			for (int c = 0; c < 3; ++c)
				p += view[k].position(
						 std::size_t(view[k].triangle(std::size_t(at.face))[std::size_t(c)])) *
					 double(at.weight[c]);
			EXPECT_LT(length(p - part.mesh.positions[v]), 0.02);
		}
		EXPECT_EQ(part.region.empty(), k != 1);
		for (std::size_t f = 0; f < part.region.size(); ++f) {
			ASSERT_LT(std::size_t(part.facePoints[f].face), label.size());
			EXPECT_EQ(part.region[f], label[std::size_t(part.facePoints[f].face)]);
		}
	}
}

} // namespace

} // namespace gpr_test
