// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A number of faces: exactly this number, or a refusal that names two possible numbers.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/run_options.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <cstdlib>
#include <gtest/gtest.h>
#include <regex>
#include <string>
#include <vector>

namespace gpr::test {

namespace {

RemeshOptions faceOptions(std::int64_t faceNum)
{
	RemeshOptions options = countOptions(0);
	options.targetMode    = TargetMode::FaceNum;
	options.targetFaceNum = faceNum;
	options.sew           = false;
	return options;
}

struct Shape {
	const char*  name;
	TriangleMesh mesh;
	bool         isClosed;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

std::vector<Shape> shapes()
{
	Random random(1);
	return {{"sphere", icosphere(4), true},
			{"cube", cube(8), true},
			{"torus", torus(40, 20), true},
			{"twoSpheres", joined(icosphere(3), shifted(icosphere(2), {3, 0, 0})), true},
			{"grid", grid(20, 20), false},
			{"cylinder", openCylinder(24, 24, 0.5, 1.5), false},
			{"gridWithHoles", withHoles(grid(30, 30), 2, random), false}};
}

/// The numbers after the first clause of a refusal.
std::vector<std::int64_t> namedIn(const std::string& message)
{
	const std::string         tail = message.substr(message.find(';') + 1);
	const std::regex          number("[0-9]+");
	std::vector<std::int64_t> all;
	for (std::sregex_iterator it(tail.begin(), tail.end(), number), end; it != end; ++it)
		all.push_back(std::stoll(it->str()));
	return all;
}

void expectExactly(const Shape& shape, std::int64_t faceNum, const RemeshOptions& options)
{
	const RemeshResult r = remesh(shape.mesh.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << faceNum << " faces: " << r.message;
	EXPECT_EQ(std::int64_t(r.mesh.faceNum()), faceNum);
	EXPECT_TRUE(isSoundSurface(r.mesh)) << faceNum << " faces";
	EXPECT_TRUE(hasSameTopology(r.mesh, shape.mesh)) << faceNum << " faces";
}

class FaceCount : public ::testing::TestWithParam<Shape> {};

TEST_P(FaceCount, IsExactOrTwoOthersAreNamed)
{
	for (std::int64_t n : {1, 6, 17, 40, 101, 300, 999, 1000, 2222}) {
		SCOPED_TRACE(n);
		const RemeshResult r = remesh(GetParam().mesh.view(), faceOptions(n));
		if (r.status == Status::Ok) {
			expectExactly(GetParam(), n, faceOptions(n));
			continue;
		}
		EXPECT_TRUE(n < 50 || (n % 2 != 0 && GetParam().isClosed)) << r.message;
		const std::vector<std::int64_t> named = namedIn(r.message);
		ASSERT_GE(named.size(), 2u) << r.message;
		for (int k : {0, 1})
			expectExactly(GetParam(), named[std::size_t(k)], faceOptions(named[std::size_t(k)]));
	}
}

TEST_P(FaceCount, TheNearestIsTakenWhereThatIsAllowed)
{
	RemeshOptions options = faceOptions(501);
	options.allowNearest  = true;
	const RemeshResult r  = remesh(GetParam().mesh.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(std::int64_t(r.mesh.faceNum()), GetParam().isClosed ? 500 : 501);
	EXPECT_EQ(r.report.targetVertexNum, std::int64_t(r.mesh.vertexNum()));
	if (GetParam().isClosed) {
		EXPECT_FALSE(r.notes.empty());
	}
}

INSTANTIATE_TEST_SUITE_P(, FaceCount, ::testing::ValuesIn(shapes()),
						 [](const auto& shape) { return std::string(shape.param.name); });

/// A note tells the number, and a finer detail has more vertices. A sphere has its error
/// everywhere, so its error is larger than the error of other meshes.
TEST(CountOfADetail, IsForecastAndTold)
{
	const TriangleMesh mesh = icosphere(5);
	std::int64_t       last = 0;
	for (const Detail detail : {Detail::Coarse, Detail::Normal, Detail::Fine}) {
		RemeshOptions options = countOptions(0);
		options.targetMode    = TargetMode::Detail;
		options.targetDetail  = detail;
		options.check         = true;
		const RemeshResult r  = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const double wanted = detailError(detail) * r.report.input.diagonal;
		EXPECT_LT(r.report.check.distance.larger().p999, 2 * wanted);
		EXPECT_GT(r.report.check.distance.larger().p999, 0.3 * wanted);
		const std::int64_t num = std::int64_t(r.mesh.vertexNum());
		EXPECT_GT(num, last);
		last = num;
		ASSERT_FALSE(r.notes.empty());
		EXPECT_EQ(r.notes.front().find("About " + std::to_string(num) + " vertices"), 0u);
	}
}

/// The border decides whether the number is odd.
TEST(FaceCountOfABorderThatIsKept, HasTheParityOfTheBorder)
{
	const TriangleMesh mesh    = grid(20, 20); // 76 edges at the border, or so: an even number
	RemeshOptions      options = faceOptions(501);
	options.boundary           = BoundaryMode::Keep;
	const RemeshResult refused = remesh(mesh.view(), options);
	EXPECT_EQ(refused.status, Status::PromiseBroken);
	EXPECT_NE(refused.message.find("found are 500 and 502"), std::string::npos) << refused.message;
	expectExactly({"grid", mesh, false}, 500, [&] {
		options.targetFaceNum = 500;
		return options;
	}());
}

TEST(FaceCountOfAClosedSurface, IsTheMeshOfThatManyVertices)
{
	const TriangleMesh mesh     = icosphere(4);
	const RemeshResult faces    = remesh(mesh.view(), faceOptions(1000));
	RemeshOptions      counts   = countOptions(502);
	counts.sew                  = false;
	const RemeshResult vertices = remesh(mesh.view(), counts);
	EXPECT_EQ(faces.mesh.triangles, vertices.mesh.triangles);
	EXPECT_EQ(faces.mesh.positions, vertices.mesh.positions);
}

} // namespace

} // namespace gpr::test
