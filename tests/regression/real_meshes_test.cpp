// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Real scans and parts, with bands for the figures: see the table in bands.cpp. One model comes
// from Debian's glmark2-data. The environment variable GPR_MODELS_DIR names the folder of the other
// models; their tests are skipped without the variable.

#include "bands.h"

#include <tests/support/mesh_audit.h>
#include <tests/support/model_files.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace gpr::test {

namespace {

void expectAtLeast(double figure, double band, const char* what)
{
	if (band == any) return;
	EXPECT_GE(figure, band) << what;
}

void expectAtMost(double figure, double band, const char* what)
{
	if (band == any) return;
	EXPECT_LE(figure, band) << what;
}

TriangleMesh withoutLowestFifth(const TriangleMesh& mesh)
{
	const auto isLower = [](const Vec3d& p, const Vec3d& q) { return p.y < q.y; };
	const auto [low, high] =
		std::minmax_element(mesh.positions.begin(), mesh.positions.end(), isLower);
	const double height = low->y + 0.2 * (high->y - low->y);
	TriangleMesh rest;
	rest.positions = mesh.positions;
	for (auto t = mesh.triangles.begin(); t != mesh.triangles.end(); t += 3) {
		if (std::all_of(t, t + 3,
						[&](int v) { return mesh.positions[std::size_t(v)].y >= height; }))
			rest.triangles.insert(rest.triangles.end(), t, t + 3);
	}
	return withoutUnused(rest);
}

RemeshOptions optionsOf(const Band& band)
{
	RemeshOptions options;
	applyWords(band.options, options);
	options.threads           = 2;
	options.check             = band.rms != any || band.p999 != any || band.hausdorff != any;
	options.targetMode        = band.target.mode;
	options.targetVertexNum   = std::int64_t(band.target.value);
	options.targetPercent     = band.target.value;
	options.targetMaxError    = band.target.value;
	options.maxErrorIsPercent = true;
	return options;
}

/// The paper's way lands 8 to 12 % below the target, 1 to 8 % in its own Table 1.
void expectCount(const Band& band, const RemeshOptions& options, std::size_t inputNum,
				 const RemeshResult& r)
{
	const auto num = std::int64_t(r.mesh.vertexNum());
	if (band.target.mode == TargetMode::MaxError) {
		EXPECT_LE(num, band.target.mostVertices);
		EXPECT_LE(r.report.provenDistance.hausdorff().upper, r.report.errorGoal);
		return;
	}
	const double wanted = band.target.mode == TargetMode::VertexNum
							  ? band.target.value
							  : std::round(band.target.value / 100 * double(inputNum));
	if (isPaper(options)) {
		EXPECT_NEAR(double(num) / wanted, 0.9, 0.025);
	}
	else if (band.traits & Repaired) {
		EXPECT_GE(double(num), wanted) << "many components need more";
	}
	else {
		EXPECT_EQ(double(num), wanted);
	}
}

void expectTopology(const RemeshResult& r)
{
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_TRUE(r.report.audit.passed);
	const SurfaceFacts facts = factsOf(r.mesh);
	EXPECT_EQ(facts.components, r.report.cleanedInput.components);
	EXPECT_EQ(facts.boundaryLoops, r.report.cleanedInput.boundaryLoops);
	EXPECT_EQ(facts.euler(), r.report.cleanedInput.eulerCharacteristic);
}

void expectShapes(const Band& band, const RemeshResult& r)
{
	const QualityFigures q = measureQuality(r.mesh.view(), 2);
	expectAtLeast(q.radiusRatioMean, band.radiusRatio, "2r/R");
	expectAtLeast(q.aspectRatioMean, band.aspectRatio, "aspect ratio");
	expectAtLeast(q.minAngleDeg, band.angle, "smallest angle");
	expectAtLeast(q.valence6Percent, band.valence6, "valence 6");
	expectAtMost(q.below30Percent, band.below30, "below 30 degrees");
	expectAtMost(double(r.report.audit.invertedFaces), band.inverted, "inverted faces");
}

/// In the direction with the larger distances, in % of the input's diagonal.
void expectDistances(const Band& band, const RemeshReport& report)
{
	const double          percent = 100 / report.input.diagonal;
	const SurfaceDistance sampled = report.check.distance.larger().times(percent);
	expectAtMost(sampled.rms, band.rms, "rms");
	expectAtMost(sampled.p999, band.p999, "p99.9");
	expectAtMost(report.provenDistance.hausdorff().times(percent).upper, band.hausdorff,
				 "Hausdorff");
}

/// Whole creases of the original are creases of the result, except creases shorter than three
/// edges.
void expectLines(const Band& band, const TriangleMesh& original, const RemeshResult& r)
{
	const double edge = measureQuality(r.mesh.view(), 2).meanEdgeLen;
	if (band.creases != any) {
		const auto kept = withoutShortPieces(sharpSegments(original, 40), 3 * edge);
		ASSERT_FALSE(kept.empty());
		EXPECT_LE(segmentDistance(kept, sharpSegments(r.mesh, 25)) / edge, band.creases);
	}
	if (band.rim != any) {
		const double rounding = 1e-5;
		EXPECT_LE(rimDistance(r.mesh, original) / edge, band.rim + rounding);
		EXPECT_LE(rimDistance(original, r.mesh) / edge, band.rim + rounding);
	}
}

void expectTraits(const Band& band, const RemeshResult& r)
{
	if (band.traits & NoLines) {
		EXPECT_EQ(r.report.featureEdgeNum, 0);
	}
	if (band.traits & Repaired) {
		EXPECT_TRUE(r.report.cleaned.changedInput());
	}
	if (band.traits & Apart) {
		Workers workers(2, nullptr);
		EXPECT_TRUE(findTouchingPairs(halfEdgesOf(r.mesh), workers).empty());
		EXPECT_EQ(r.report.audit.guarded.inputFaceNum, 0);
		EXPECT_LE(r.report.audit.guarded.vertexNum, std::int64_t(r.mesh.vertexNum() / 5))
			<< "only patches are made anew";
	}
}

class RealMesh : public ::testing::TestWithParam<Band> {};

TEST_P(RealMesh, StaysWithinItsBands)
{
	const Band&     band  = GetParam();
	const ModelFile model = findModel(band.file);
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	TriangleMesh mesh = triangleMeshOf(app::readMesh(model.path).view());
	if (isOpened(band)) mesh = withoutLowestFifth(mesh);
	const RemeshOptions options = optionsOf(band);
	const RemeshResult  r       = remesh(mesh.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	expectCount(band, options, mesh.vertexNum(), r);
	expectTopology(r);
	expectShapes(band, r);
	expectDistances(band, r.report);
	expectLines(band, mesh, r);
	expectTraits(band, r);
}

INSTANTIATE_TEST_SUITE_P(, RealMesh, ::testing::ValuesIn(bands()),
						 [](const auto& row) { return std::string(row.param.name); });

/// A range map with ragged borders; by default more than a third of the vertices lie on the
/// borders.
TEST(SmoothBorder, LeavesFewSmallAnglesOnARangeMap)
{
	const ModelFile model = findModel("rangemap_lato315_121k_open_32comp.ply");
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	const app::InputMesh input   = app::readMesh(model.path);
	double               below30 = 0;
	for (std::uint32_t seed : {1u, 2u, 3u}) {
		RemeshOptions options;
		options.targetPercent = 10;
		options.seed          = seed;
		options.threads       = 2;
		options.check         = true;
		options.boundary      = BoundaryMode::Smooth;
		const RemeshResult r  = remesh(input.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(isSoundSurface(r.mesh));
		const SurfaceFacts facts = factsOf(r.mesh);
		EXPECT_EQ(facts.components, 39); // as in the repaired scan
		EXPECT_EQ(facts.boundaryLoops, 60);
		EXPECT_EQ(facts.euler(), 18);
		EXPECT_GE(r.report.quality.radiusRatioMean, 0.965);
		EXPECT_LE(r.report.border.resultLength, 0.8 * r.report.border.length);
		below30 += r.report.quality.below30Percent / 3;
	}
	EXPECT_LE(below30, 0.4); // 4.3 by default
}

/// An electronic part of 104 faces with separate vertices. Sewn, the part is a single solid;
/// unsewn, each face is a component.
TEST(SplitSeams, APartOfManyPatchesIsOneSolid)
{
	const ModelFile model = findModel("cad_split_seams_104comp.ply");
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	const app::InputMesh input = app::readMesh(model.path);
	RemeshOptions        options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = 2000;
	options.threads         = 2;
	const RemeshResult r    = remesh(input.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_EQ(r.report.cleaned.sewnEdges, 692);
	EXPECT_EQ(r.report.cleaned.sharedBorderEdges, 0);
	EXPECT_EQ(factsOf(r.mesh).components, 1);
	EXPECT_EQ(factsOf(r.mesh).borderEdges, 0) << "no crack";
	EXPECT_EQ(std::int64_t(r.mesh.vertexNum()), 2000);
	EXPECT_LE(r.report.quality.below30Percent, 10);
	EXPECT_GT(r.report.featureEdgeNum, 500);
	options.sew              = false;
	const RemeshResult apart = remesh(input.view(), options);
	ASSERT_EQ(apart.status, Status::Ok) << apart.message;
	EXPECT_EQ(factsOf(apart.mesh).components, 104);
}

} // namespace

} // namespace gpr::test
