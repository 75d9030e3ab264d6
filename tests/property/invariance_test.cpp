// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Another place, size or numbering of the mesh changes the result, but not the statistics of the
// result.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

struct Change {
	const char* name;
	TriangleMesh (*apply)(const TriangleMesh&);
	double lengthFactor = 1;
};

std::ostream& operator<<(std::ostream& out, const Change& change)
{
	return out << change.name;
}

TriangleMesh renumbered(const TriangleMesh& mesh)
{
	Random random(42);
	return shuffled(mesh, random);
}

std::vector<Change> changes()
{
	return {{"asItIs", [](const TriangleMesh& m) { return m; }},
			{"rotated",
			 [](const TriangleMesh& m) {
				 return rotated(m, {1, 2, 3}, 1);
			 }},
			{"upsideDown",
			 [](const TriangleMesh& m) {
				 return rotated(m, {1, 0, 0}, 3.14159265358979);
			 }},
			{"shiftedALittle",
			 [](const TriangleMesh& m) {
				 return shifted(m, {3.3, -1.7, 0.9});
			 }},
			{"atUtmCoordinates",
			 [](const TriangleMesh& m) {
				 return shifted(m, {455123.25, 4978321.5, 812.75});
			 }},
			{"tiny", [](const TriangleMesh& m) { return scaled(m, 1e-9); }, 1e-9},
			{"huge", [](const TriangleMesh& m) { return scaled(m, 1e9); }, 1e9},
			{"renumbered", renumbered},
			{"insideOut", insideOut}};
}

class Invariance : public ::testing::TestWithParam<Change> {
protected:
	/// band: of mean shape and edge length, relative.
	void expectSameStatistics(const TriangleMesh& mesh, double percent, double band,
							  double minAngleDeg)
	{
		RemeshOptions options;
		options.targetPercent    = percent;
		options.threads          = 2;
		const RemeshResult plain = remesh(mesh.view(), options);
		ASSERT_EQ(plain.status, Status::Ok) << plain.message;
		const TriangleMesh changed = GetParam().apply(mesh);
		const RemeshResult r       = remesh(changed.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(r.mesh.vertexNum(), plain.mesh.vertexNum());
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(r.mesh, mesh));
		const QualityFigures &a = plain.report.quality, &b = r.report.quality;
		EXPECT_NEAR(b.radiusRatioMean, a.radiusRatioMean, band * a.radiusRatioMean);
		EXPECT_NEAR(b.aspectRatioMean, a.aspectRatioMean, 2 * band * a.aspectRatioMean);
		EXPECT_NEAR(b.meanEdgeLen / GetParam().lengthFactor, a.meanEdgeLen, band * a.meanEdgeLen);
		EXPECT_GT(b.minAngleDeg, minAngleDeg);
	}
};

TEST_P(Invariance, ClosedSmooth)
{
	expectSameStatistics(torus(90, 46), 25, 0.01, 30);
}

TEST_P(Invariance, ClosedWithCreases)
{
	expectSameStatistics(cube(30), 20, 0.015, 15);
}

/// A wider band: by chance the front closes in squares or in triangles between straight rims.
TEST_P(Invariance, Open)
{
	expectSameStatistics(openCylinder(70, 70, 0.5, 1.5), 20, 0.02, 25);
}

INSTANTIATE_TEST_SUITE_P(, Invariance, ::testing::ValuesIn(changes()),
						 [](const auto& shape) { return std::string(shape.param.name); });

/// Single and double precision describe the same surface.
TEST(Precision, FloatInputGivesTheSameAsItsExactDoubles)
{
	const FloatMesh single(torus(60, 30));
	TriangleMesh    doubled;
	for (const Vec3f& p : single.positions)
		doubled.positions.push_back(Vec3d(p));
	doubled.triangles = single.triangles;
	RemeshOptions options;
	options.threads      = 2;
	const RemeshResult a = remesh(single.view(), options), b = remesh(doubled.view(), options);
	ASSERT_EQ(a.status, Status::Ok);
	EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
	EXPECT_TRUE(a.mesh.positions == b.mesh.positions);
}

/// A scan at UTM coordinates keeps millimetres: the result lies on the surface up to the rounding
/// of floats at the size of the surface, not at its place.
TEST(Precision, FarAwayNothingIsLost)
{
	const Vec3d        offset(455123.25, 4978321.5, 812.75);
	const TriangleMesh sphere = shifted(icosphere(4, 50), offset);
	RemeshOptions      options;
	options.preset       = Preset::Paper;
	const RemeshResult r = remesh(sphere.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	for (const Vec3d& p : r.mesh.positions) {
		const double radius = length(p - offset);
		ASSERT_LE(radius, 50.0001);
		ASSERT_GE(radius, 49.8) << "the chords of the input's faces";
	}
}

/// At this place neighbouring doubles are an eighth of a unit apart, and corners of small triangles
/// coincide or lie in a line.
TEST(FarOffset, WhatRoundingSpoilsIsWithheld)
{
	const TriangleMesh mesh     = shifted(grid(32, 32, 4, 4), {1e15, 1e15, 0});
	int                withheld = 0;
	for (double percent : {3.0, 20.0, 100.0, 200.0}) {
		RemeshOptions options;
		options.targetMode    = TargetMode::Percent;
		options.targetPercent = percent;
		const RemeshResult r  = remesh(mesh.view(), options);
		if (r.status == Status::Ok) {
			EXPECT_EQ(factsOf(r.mesh).zeroAreaFaces, 0) << percent;
			continue;
		}
		EXPECT_EQ(r.status, Status::PromiseBroken) << r.message;
		++withheld;
	}
	EXPECT_GE(withheld, 1);
}

} // namespace

} // namespace gpr::test
