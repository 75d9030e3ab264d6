// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whole runs with surfaces close to each other or flattened: no faces intersect, and noise makes no
// feature lines.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace gpr::test {

namespace {

/// A ridge, curved along x, under a flat sheet. The fit would raise the triangles of the ridge by
/// more than the gap.
TriangleMesh ridgeUnderSheet(double gap)
{
	TriangleMesh ridge = grid(100, 100);
	for (Vec3d& p : ridge.positions)
		p.z = -0.75 * (p.x - 0.5) * (p.x - 0.5);
	return joined(ridge, shifted(grid(100, 100), {0.003, 0.004, gap}));
}

TriangleMesh roughSphere()
{
	Random random(7);
	return noisySphere(5, 0.02, random);
}

struct Shape {
	const char*                   name;
	std::function<TriangleMesh()> make;
	int                           vertexNum;
	bool                          hasLines;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

std::size_t crossingNum(const TriangleMesh& mesh)
{
	Workers workers(2, nullptr);
	return facesOf(findTouchingPairs(halfEdgesOf(mesh), workers)).size();
}

} // namespace

TEST(IntersectingFaces, AreFoundInTheseResultsOnceTheyCross)
{
	EXPECT_EQ(crossingNum(ridgeUnderSheet(0.002)), 0u);
	EXPECT_GT(crossingNum(ridgeUnderSheet(-0.002)), 0u);
}

class CloseSurfaces : public ::testing::TestWithParam<Shape> {};

TEST_P(CloseSurfaces, DoNotCross)
{
	const TriangleMesh mesh = GetParam().make();
	for (const double adapt : {0.0, 1.0}) {
		RemeshOptions options;
		options.targetMode      = TargetMode::VertexNum;
		options.targetVertexNum = GetParam().vertexNum;
		options.adapt           = adapt;
		options.threads         = 2;
		const RemeshResult r    = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(int(r.mesh.vertexNum()), GetParam().vertexNum);
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
		EXPECT_EQ(crossingNum(r.mesh), 0u) << "adapt " << adapt;
		EXPECT_EQ(r.report.featureEdgeNum > 0, GetParam().hasLines);
	}
}

INSTANTIATE_TEST_SUITE_P(
	, CloseSurfaces,
	::testing::Values(Shape{"sheets", [] { return ridgeUnderSheet(0.002); }, 250, false},
					  Shape{"flatSheets", [] { return twoSheets(80, 0.001); }, 400, false},
					  Shape{"cone", [] { return cone(90, 40, 0.5, 2); }, 300, false},
					  Shape{"thinPlate", [] { return thinPlate(60, 0.002); }, 500, true},
					  Shape{"noisySphere", roughSphere, 800, false}),
	[](const auto& shape) { return shape.param.name; });

/// A sphere pressed flat: its creases lie on each other and in a line, with degenerate faces
/// between.
TEST(FoldedFlat, TrianglesHaveAnArea)
{
	for (const std::uint32_t seed : {1u, 2u}) {
		Random       random(seed);
		TriangleMesh flat = noisySphere(4, 0.1, random);
		for (Vec3d& p : flat.positions)
			p.z = 0;
		RemeshOptions options;
		options.targetPercent = 50;
		const RemeshResult r  = remesh(flat.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(factsOf(r.mesh).complaints(), "");
	}
}

namespace {

/// A grid with edges twice as long on the border as inside.
TriangleMesh gridWithCoarseBorder(int n)
{
	TriangleMesh mesh = grid(n, n);
	// Every second vertex of the border moves to the vertex before.
	std::map<std::pair<double, double>, std::int32_t> at;
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v)
		at[{std::round(n * mesh.positions[v].x), std::round(n * mesh.positions[v].y)}] =
			std::int32_t(v);
	std::vector<std::int32_t> goesTo(mesh.vertexNum());
	for (const auto& [place, v] : at) {
		const auto [x, y]   = place;
		const bool   alongX = y == 0 || y == n, alongY = x == 0 || x == n;
		const double dx = alongX && std::fmod(x, 2) == 1, dy = alongY && std::fmod(y, 2) == 1;
		goesTo[std::size_t(v)] = at[{x - dx, y - dy}];
	}
	std::vector<std::int32_t> triangles;
	for (std::size_t c = 0; c < mesh.triangles.size(); c += 3) {
		std::int32_t t[3];
		for (std::size_t k = 0; k < 3; ++k)
			t[k] = goesTo[std::size_t(mesh.triangles[c + k])];
		if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
			triangles.insert(triangles.end(), t, t + 3);
	}
	mesh.triangles = triangles;
	return mesh;
}

/// Two sheets with waves, which are nearer to each other than the triangles' chords to the waves.
TriangleMesh wavySheets()
{
	TriangleMesh sheet = gridWithCoarseBorder(100);
	for (Vec3d& p : sheet.positions)
		p.z = 0.05 * std::sin(12 * p.x) * std::cos(9 * p.y);
	return joined(sheet, shifted(sheet, {0, 0, 0.0004}));
}

/// Border edges by their ends.
std::set<std::pair<std::int32_t, std::int32_t>> borderEdgesOf(const TriangleMesh& mesh)
{
	std::map<std::pair<std::int32_t, std::int32_t>, int> faceNum;
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c)
		++faceNum[std::minmax(mesh.triangles[c], mesh.triangles[c % 3 == 2 ? c - 2 : c + 1])];
	std::set<std::pair<std::int32_t, std::int32_t>> edges;
	for (const auto& [edge, num] : faceNum) {
		if (num == 1) edges.insert(edge);
	}
	return edges;
}

} // namespace

/// Triangles made by edge collapses of the input keep a border edge by edge, too.
TEST(CloseSurfacesWithBorders, KeepTheirBorderWhereTrianglesAreMadeAnew)
{
	const TriangleMesh mesh = wavySheets();
	for (const int count : {4200, 4600, 5000}) {
		RemeshOptions options;
		options.preset          = Preset::Fast;
		options.targetMode      = TargetMode::VertexNum;
		options.targetVertexNum = count;
		options.boundary        = BoundaryMode::Keep;
		const RemeshResult r    = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_GT(r.report.audit.guarded.vertexNum, 0) << count;
		EXPECT_EQ(int(r.mesh.vertexNum()), count);
		std::set<std::pair<std::int32_t, std::int32_t>> kept;
		for (const auto& [a, b] : borderEdgesOf(r.mesh))
			kept.insert(
				std::minmax(r.callersVertex[std::size_t(a)], r.callersVertex[std::size_t(b)]));
		EXPECT_EQ(kept, borderEdgesOf(mesh)) << count;
	}
}

/// A kept border counts more than contacts, so the run is refused if contacts are left.
TEST(CloseSurfacesWithBorders, TrianglesBesideAKeptBorderDoNotIntersect)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
	mesh.triangles = {0, 1, 2};
	for (const int count : {150, 600, 2000}) {
		RemeshOptions options;
		options.targetMode      = TargetMode::VertexNum;
		options.targetVertexNum = count;
		options.boundary        = BoundaryMode::Keep;
		const RemeshResult r    = remesh(mesh.view(), options);
		if (r.status == Status::Ok)
			EXPECT_EQ(r.report.audit.guarded.pairNum, 0) << count;
		else
			EXPECT_EQ(r.status, Status::CountTooSmall) << count << ": " << r.message;
	}
}

} // namespace gpr::test
