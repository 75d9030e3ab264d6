// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Results with too few vertices for their shape name the number with which they would be regular.

#include <tests/support/mesh_builders.h>
#include <tests/support/run_options.h>
#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace gpr::test {

namespace {

struct Part {
	const char*  name;
	TriangleMesh mesh;
	int          few;    ///< far too few vertices
	double       factor; ///< within which the forecast is right
};

std::vector<Part> narrowParts()
{
	return {{"plate", box(20, 20, 1, {10, 10, 0.2f}), 100, 1.5},
			{"strip", box(40, 8, 1, {10, 2, 0.1f}), 100, 1.5},
			{"box", box(12, 6, 1, {6, 3, 0.12f}), 100, 1.75},
			// Rims without corners suit the triangles earlier.
			{"coin", closedCylinder(96, 1, 5, 0.25), 100, 2},
			{"ring", ringPlate(96, 0.6, 0.04), 80, 2}};
}

bool hasNote(const RemeshResult& result, const char* words = "make nearly all faces regular")
{
	for (const std::string& note : result.notes)
		if (note.find(words) != std::string::npos) return true;
	return false;
}

/// A square plate with narrow ribs: rows of a grid, raised in pairs.
TriangleMesh ribbedPlate()
{
	constexpr int n    = 60;
	TriangleMesh  mesh = grid(n, n);
	for (Vec3d& p : mesh.positions) {
		if (std::lround(p.x * n) % 4 >= 2) p.z += 1.5 / n;
	}
	return mesh;
}

double below30(const TriangleMesh& mesh, std::int64_t vertexNum)
{
	return remesh(MeshView(mesh.positions, mesh.triangles), countOptions(int(vertexNum)))
		.report.quality.below30Percent;
}

} // namespace

TEST(RegularCount, IsForecastWithinAFactor)
{
	constexpr double mostIrregular = 5; // percent
	for (const Part& part : narrowParts()) {
		SCOPED_TRACE(part.name);
		const RemeshResult few =
			remesh(MeshView(part.mesh.positions, part.mesh.triangles), countOptions(part.few));
		ASSERT_GT(few.report.quality.below30Percent, 20);
		const std::int64_t num = few.report.regularVertexNum;
		ASSERT_GT(num, part.few);
		EXPECT_TRUE(hasNote(few));
		EXPECT_LE(below30(part.mesh, std::int64_t(part.factor * double(num))), mostIrregular)
			<< num;
		EXPECT_GT(below30(part.mesh, std::int64_t(double(num) / part.factor)), mostIrregular)
			<< num;
	}
}

/// Triangles that round the ribs off may be as regular as triangles on a plain plate.
TEST(RegularCount, IsForecastWhereCreasesAreRoundedOff)
{
	const TriangleMesh mesh = ribbedPlate();
	const MeshView     input(mesh.positions, mesh.triangles);
	const RemeshResult few = remesh(input, countOptions(150));
	EXPECT_LT(few.report.quality.below30Percent, 20);
	EXPECT_TRUE(hasNote(few, "crease edges are rounded off there"));
	const std::int64_t num = few.report.regularVertexNum;
	ASSERT_GT(num, 300);
	const RemeshResult many = remesh(input, countOptions(int(2 * num)));
	EXPECT_EQ(many.report.regularVertexNum, 0);
	EXPECT_GT(many.report.featureEdgeNum, 0);
}

TEST(RegularCount, IsNotToldOfARegularResult)
{
	for (const TriangleMesh& mesh : {icosphere(4), cube(10)}) {
		const RemeshResult result =
			remesh(MeshView(mesh.positions, mesh.triangles), countOptions(300));
		EXPECT_EQ(result.report.regularVertexNum, 0);
		EXPECT_FALSE(hasNote(result));
	}
}

} // namespace gpr::test
