// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Edge lengths in mesh units: for each vertex, the least and the largest, and walls thinner than an
// edge.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/run_options.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace gpr::test {

namespace {

RemeshOptions sizeOptions()
{
	RemeshOptions options = countOptions(0);
	options.targetMode    = TargetMode::Sizes;
	return options;
}

/// From `least` at z = -1 to `most` at z = 1.
double lengthAt(double z, double least, double most)
{
	return least + (most - least) * 0.5 * (std::clamp(z, -1.0, 1.0) + 1);
}

/// Over the wanted length at the middle of each edge: the edge length.
std::vector<double> overWanted(const TriangleMesh& mesh, double least, double most)
{
	std::vector<double> all;
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
		const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
		const Vec3d&      p    = mesh.positions[std::size_t(mesh.triangles[c])];
		const Vec3d&      q    = mesh.positions[std::size_t(mesh.triangles[next])];
		all.push_back(length(p - q) / lengthAt(0.5 * (p.z + q.z), least, most));
	}
	return all;
}

double meanOf(const std::vector<double>& values)
{
	double sum = 0;
	for (const double v : values)
		sum += v;
	return sum / double(values.size());
}

std::vector<float> lengthsOf(const TriangleMesh& mesh, double least, double most)
{
	std::vector<float> lengths;
	for (const Vec3d& p : mesh.positions)
		lengths.push_back(float(lengthAt(p.z, least, most)));
	return lengths;
}

} // namespace

TEST(Sizes, AreMetByTheCountThatFollows)
{
	const TriangleMesh       mesh    = icosphere(5);
	const std::vector<float> lengths = lengthsOf(mesh, 0.03, 0.2);
	MeshView                 view    = mesh.view();
	view.wantedEdge                  = lengths.data();
	const RemeshResult r             = remesh(view, sizeOptions());
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	const std::vector<double> ratios = overWanted(r.mesh, 0.03, 0.2);
	EXPECT_NEAR(meanOf(ratios), 1, 0.02);
	const auto near =
		std::count_if(ratios.begin(), ratios.end(), [](double x) { return x > 0.8 && x < 1.25; });
	EXPECT_GT(double(near), 0.9 * double(ratios.size()));
	EXPECT_GT(r.report.quality.minAngleDeg, 30);
}

TEST(Sizes, AreScaledToACount)
{
	const TriangleMesh       mesh    = icosphere(5);
	const std::vector<float> lengths = lengthsOf(mesh, 3, 20);
	MeshView                 view    = mesh.view();
	view.wantedEdge                  = lengths.data();
	const RemeshResult r             = remesh(view, countOptions(2000));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.mesh.vertexNum(), 2000u);
	const std::vector<double> ratios = overWanted(r.mesh, 3, 20);
	const double              mean   = meanOf(ratios);
	const auto                near   = std::count_if(ratios.begin(), ratios.end(),
													 [&](double x) { return x > 0.8 * mean && x < 1.25 * mean; });
	EXPECT_GT(double(near), 0.9 * double(ratios.size()));
}

TEST(Sizes, AreKeptBetweenTheLeastAndTheLargestEdge)
{
	const TriangleMesh       mesh    = icosphere(5);
	const std::vector<float> lengths = lengthsOf(mesh, 0.001, 1);
	MeshView                 view    = mesh.view();
	view.wantedEdge                  = lengths.data();
	RemeshOptions options            = sizeOptions();
	options.minEdge                  = 0.08;
	options.maxEdge                  = 0.1;
	const RemeshResult r             = remesh(view, options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_GT(r.report.quality.meanEdgeLen, 0.08);
	EXPECT_LT(r.report.quality.meanEdgeLen, 0.1);
}

TEST(Sizes, OfTheLargestEdgeAloneGiveTheCount)
{
	RemeshOptions options = sizeOptions();
	options.maxEdge       = 0.1;
	const RemeshResult r  = remesh(icosphere(4).view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_NEAR(r.report.quality.meanEdgeLen, 0.1, 0.003);
}

/// A length in percent of the diagonal is the same run as its length in mesh units.
TEST(Sizes, InPercentAreSharesOfTheDiagonal)
{
	const TriangleMesh mesh     = icosphere(4);
	const double       diagonal = 2 * std::sqrt(3.0);
	RemeshOptions      units = sizeOptions(), percent = sizeOptions();
	units.minEdge            = 0.02 * diagonal;
	units.maxEdge            = 0.04 * diagonal;
	percent.minEdge          = 2;
	percent.maxEdge          = 4;
	percent.minEdgeIsPercent = percent.maxEdgeIsPercent = true;
	const RemeshResult a = remesh(mesh.view(), units), b = remesh(mesh.view(), percent);
	ASSERT_EQ(b.status, Status::Ok) << b.message;
	EXPECT_NEAR(b.report.quality.meanEdgeLen, 0.04 * diagonal, 0.003 * diagonal);
	EXPECT_EQ(a.mesh.vertexNum(), b.mesh.vertexNum());

	percent.minEdge          = 0.02 * diagonal; // of another unit than the largest
	percent.minEdgeIsPercent = false;
	EXPECT_EQ(remesh(mesh.view(), percent).mesh.vertexNum(), b.mesh.vertexNum());
	percent.minEdge = 0.05 * diagonal;
	EXPECT_EQ(remesh(mesh.view(), percent).status, Status::BadOptions) << "above the largest";

	RemeshOptions edge    = countOptions(0);
	edge.targetMode       = TargetMode::EdgeLength;
	edge.targetEdgeLen    = 4;
	edge.edgeLenIsPercent = true;
	EXPECT_NEAR(remesh(mesh.view(), edge).report.quality.meanEdgeLen, 0.04 * diagonal,
				0.003 * diagonal);
}

TEST(Sizes, ThatCannotBeMeantAreRefused)
{
	const TriangleMesh mesh = icosphere(3);
	EXPECT_EQ(remesh(mesh.view(), sizeOptions()).status, Status::BadOptions) << "there are none";
	for (const float bad : {0.0f, -1.0f, float(NAN), float(INFINITY)}) {
		std::vector<float> lengths(mesh.vertexNum(), 0.1f);
		lengths[5]      = bad;
		MeshView view   = mesh.view();
		view.wantedEdge = lengths.data();
		EXPECT_EQ(remesh(view, sizeOptions()).status, Status::BadOptions) << bad;
	}
	RemeshOptions crossed = sizeOptions();
	crossed.minEdge       = 2;
	crossed.maxEdge       = 1;
	EXPECT_EQ(remesh(mesh.view(), crossed).status, Status::BadOptions);
}

/// As if they were not there, or as far as the count goes.
TEST(Sizes, EdgesBeyondAllThatAMeshCanHaveEnd)
{
	const TriangleMesh mesh = icosphere(4);
	for (const double length : {1e-13, 1e10, 5e38, 1e300}) {
		RemeshOptions least = countOptions(300), most = countOptions(300), alone = sizeOptions();
		least.minEdge = most.maxEdge = alone.maxEdge = length;
		for (const RemeshOptions& options : {least, most}) {
			const RemeshResult r = remesh(mesh.view(), options);
			ASSERT_EQ(r.status, Status::Ok) << length << r.message;
			EXPECT_EQ(r.mesh.vertexNum(), 300u);
			EXPECT_GT(r.report.quality.minAngleDeg, 25);
		}
		if (length < 1) continue; // more vertices than there may be
		EXPECT_NE(remesh(mesh.view(), alone).status, Status::InternalError);
	}
}

TEST(Sizes, AreNotForThePaper)
{
	const TriangleMesh       mesh = icosphere(3);
	const std::vector<float> lengths(mesh.vertexNum(), 0.1f);
	MeshView                 view = mesh.view();
	view.wantedEdge               = lengths.data();
	RemeshOptions options         = sizeOptions();
	options.preset                = Preset::Paper;
	EXPECT_EQ(remesh(view, options).status, Status::BadOptions);
}

/// Only the two lines of a rim keep the sheets of a plate apart.
TEST(ThinWalls, KeepTheirLines)
{
	TriangleMesh plate = cube(32);
	for (Vec3d& p : plate.positions)
		p.z *= 0.004;
	const auto lower = [](const Vec3d& p, const Vec3d& q) { return p.z < q.z; };
	const auto [low, high] =
		std::minmax_element(plate.positions.begin(), plate.positions.end(), lower);
	const double bottom = low->z, top = high->z;
	for (const std::int64_t num : {500, 2000}) {
		const RemeshResult r = remesh(plate.view(), countOptions(num));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const auto isOnSheet = [&, slack = 0.02 * (top - bottom)](const Vec3d& p) {
			return std::min(std::abs(p.z - bottom), std::abs(p.z - top)) < slack;
		};
		const auto apart =
			std::count_if(r.mesh.positions.begin(), r.mesh.positions.end(), isOnSheet);
		EXPECT_GT(double(apart), 0.97 * double(r.mesh.vertexNum())) << num << " vertices";
	}
}

} // namespace gpr::test
