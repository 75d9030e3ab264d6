// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Real scans and parts, with bands that fail. The models are no part of the project: the folder is
// named by the environment variable GPR_MODELS_DIR, and where it is unset the tests are skipped.

#include <tests/support/mesh_audit.h>
#include <tests/support/model_files.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <vcg_extras/apps/gpremesh/mesh_io.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <optional>
#include <string>

namespace gpr::test {

namespace {

/// What a model must come to. Zeroes are not asked for.
struct Band {
	const char*  file;
	double       percent;
	std::int64_t vertexNum       = 0;   ///< takes the place of percent where above 0
	double       adapt           = 0;   ///< the option of that name
	double       meanRadiusRatio = 0;   ///< at least
	double       meanAspectRatio = 0;   ///< at least
	double       minAngleDeg     = 0;   ///< at least
	double       below30Percent  = 100; ///< at most
	double       valence6Percent = 0;   ///< at least
	double       rim             = 1;   ///< largest distance of the rims in mean edges, at most
	double       rmsPercent      = 0;   ///< of the diagonal, at most; 0: not asked for
	double       creases =
		0; ///< largest distance of the sharp edges from those of the result in edges, at most
	bool hasLines      = true; ///< feature lines are allowed
	bool keepsInverted = true; ///< faces against the surface are allowed
};

std::ostream& operator<<(std::ostream& out, const Band& band)
{
	return out << band.file << " to " << band.percent << " %";
}

/// Root mean square distance between input and result, in the direction in which it is larger, in %
/// of the input's diagonal: by points spread evenly on both surfaces.
double rmsPercent(const RemeshReport& report)
{
	const double rms = double(report.check.distance.larger().rms);
	return 100 * rms / report.input.diagonal;
}

/// Whole creases of the original are creases of the result; those shorter than three edges may go.
void expectCreases(const TriangleMesh& original, const RemeshResult& r, double most)
{
	const QualityFigures q    = measureQuality(r.mesh.view(), 2);
	const double         edge = q.meanEdgeLen;
	const auto           kept = withoutShortPieces(sharpSegments(original, 40), 3 * edge);
	ASSERT_FALSE(kept.empty());
	EXPECT_LE(segmentDistance(kept, sharpSegments(r.mesh, 25)) / edge, most);
}

/// Result and bands of one model.
void expectWithin(const std::string& path, const Band& band)
{
	const app::InputMesh input = app::readMesh(path);
	RemeshOptions        options;
	options.targetPercent = band.percent;
	options.adapt         = band.adapt;
	options.threads       = 2;
	options.check         = band.rmsPercent > 0;
	if (band.vertexNum > 0) {
		options.targetMode      = TargetMode::VertexNum;
		options.targetVertexNum = band.vertexNum;
	}
	const RemeshResult r = remesh(input.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_EQ(std::int64_t(r.mesh.vertexNum()),
			  band.vertexNum > 0
				  ? band.vertexNum
				  : std::int64_t(std::round(band.percent / 100 * double(input.vertexNum()))));

	const SurfaceFacts facts = factsOf(r.mesh);
	EXPECT_EQ(facts.components, r.report.cleanedInput.components);
	EXPECT_EQ(facts.boundaryLoops, r.report.cleanedInput.boundaryLoops);
	EXPECT_EQ(facts.euler(), r.report.cleanedInput.eulerCharacteristic);
	const QualityFigures q = measureQuality(r.mesh.view(), 2);
	EXPECT_GE(q.radiusRatioMean, band.meanRadiusRatio);
	EXPECT_GE(q.aspectRatioMean, band.meanAspectRatio);
	EXPECT_GE(q.valence6Percent, band.valence6Percent);
	EXPECT_GE(q.minAngleDeg, band.minAngleDeg);
	EXPECT_LE(q.below30Percent, band.below30Percent);
	if (band.rmsPercent > 0) {
		EXPECT_LE(rmsPercent(r.report), band.rmsPercent);
	}
	if (!band.keepsInverted) {
		EXPECT_EQ(r.report.audit.invertedFaces, 0);
	}
	if (!band.hasLines) {
		EXPECT_EQ(r.report.featureEdgeNum, 0);
	}
	if (band.creases > 0) expectCreases(copyOf(input.view()), r, band.creases);
	if (band.rim < 1) {
		const TriangleMesh original = copyOf(input.view());
		const double       most     = band.rim * q.meanEdgeLen;
		EXPECT_LE(rimDistance(r.mesh, original), most) << "mean edge " << q.meanEdgeLen;
		EXPECT_LE(rimDistance(original, r.mesh), most) << "mean edge " << q.meanEdgeLen;
	}
}

class RealMesh : public ::testing::TestWithParam<Band> {};

TEST_P(RealMesh, StaysWithinItsBands)
{
	const ModelFile model = findModel(GetParam().file);
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	expectWithin(model.path, GetParam());
}

std::vector<Band> bands()
{
	Band igea{"igea_269k.ply", 10};
	igea.vertexNum       = 13434;
	igea.meanRadiusRatio = 0.9915;
	igea.meanAspectRatio = 0.96;
	igea.minAngleDeg     = 31;
	igea.below30Percent  = 0;
	igea.valence6Percent = 94;
	igea.rmsPercent      = 0.0162;
	igea.keepsInverted   = false;

	Band adapted            = igea;
	adapted.adapt           = 1;
	adapted.meanRadiusRatio = 0.98;
	adapted.meanAspectRatio = 0.935;
	adapted.minAngleDeg     = 29.5;
	adapted.valence6Percent = 90;
	adapted.rmsPercent      = 0.0143;

	Band facemask{"facemask_62k_open.ply", 10};
	facemask.meanRadiusRatio = 0.989;
	facemask.meanAspectRatio = 0.954;
	facemask.minAngleDeg     = 32;
	facemask.below30Percent  = 0;
	facemask.valence6Percent = 92;
	facemask.rim             = 0.15;
	facemask.rmsPercent      = 0.0143;

	Band laurana{"laurana_50k_colour_open.ply", 10};
	laurana.meanRadiusRatio = 0.981;
	laurana.meanAspectRatio = 0.935;
	laurana.minAngleDeg     = 31;
	laurana.below30Percent  = 0;
	laurana.valence6Percent = 90;
	laurana.rmsPercent      = 0.06;
	laurana.rim             = 0.105; // its rim is ragged

	Band terrain{"terrain_N44W072_2.9M_open.ply", 10};
	terrain.meanRadiusRatio = 0.993;
	terrain.meanAspectRatio = 0.966;
	terrain.minAngleDeg     = 31;
	terrain.below30Percent  = 0;
	terrain.valence6Percent = 94;
	terrain.rmsPercent      = 0.0029;
	terrain.rim             = 0.15;

	Band iguana{"iguana_ct_skin_1.9M.ply", 10};
	iguana.meanRadiusRatio = 0.977;
	iguana.minAngleDeg     = 9; // of feet that are thinner than an edge
	iguana.below30Percent  = 0.02;
	iguana.valence6Percent = 89;
	iguana.rmsPercent      = 0.023;

	Band casting{"casting_10k_genus9.ply", 50}; // its crowded lines are released
	casting.meanRadiusRatio   = 0.952;
	casting.minAngleDeg       = 30;
	casting.below30Percent    = 0;
	casting.valence6Percent   = 79;
	casting.rmsPercent        = 0.105;
	casting.creases           = 0.36; // where lines are released a sharp edge may be rounded
	Band casting10            = casting;
	casting10.percent         = 10;
	casting10.meanRadiusRatio = 0.88;
	// One or two of the thousand triangles stay poor with every second seed.
	casting10.minAngleDeg     = 15;
	casting10.below30Percent  = 0.3;
	casting10.valence6Percent = 0;
	casting10.rmsPercent      = 0.3;
	casting10.creases         = 0;
	Band cheese{"cheese_18k_genus133.ply", 50};
	cheese.meanRadiusRatio = 0.79; // half of its vertices are on creases
	cheese.below30Percent  = 19;
	cheese.rmsPercent      = 0.27;

	Band fullSize{"rockerarm_20k.ply", 100};
	fullSize.meanRadiusRatio = 0.991;
	fullSize.minAngleDeg     = 31;
	fullSize.valence6Percent = 93;
	fullSize.rmsPercent      = 0.0252;
	Band doubled{"rockerarm_20k.ply", 200};
	doubled.meanRadiusRatio = 0.992;
	doubled.minAngleDeg     = 31;
	doubled.valence6Percent = 93;
	doubled.rmsPercent      = 0.0178;
	Band rockerarm{"rockerarm_20k.ply", 10};
	rockerarm.meanRadiusRatio = 0.967;
	rockerarm.minAngleDeg     = 31;
	rockerarm.valence6Percent = 81;
	rockerarm.rmsPercent      = 0.124;
	rockerarm.hasLines        = false; // a scan of a smooth part
	Band gargoyle{"gargoyle_96k.ply", 10};
	gargoyle.meanRadiusRatio = 0.965;
	gargoyle.minAngleDeg     = 31;
	gargoyle.valence6Percent = 82;
	gargoyle.rmsPercent      = 0.0905;
	Band fandisk{"fandisk_13k_cad.ply", 50};
	fandisk.meanRadiusRatio   = 0.975;
	fandisk.minAngleDeg       = 22;
	fandisk.below30Percent    = 0.05;
	fandisk.rmsPercent        = 0.0088;
	fandisk.creases           = 0.1;
	Band fandisk20            = fandisk;
	fandisk20.percent         = 20;
	fandisk20.meanRadiusRatio = 0.966;
	fandisk20.below30Percent  = 0.08;
	fandisk20.rmsPercent      = 0.0225;
	Band fandisk10            = fandisk;
	fandisk10.percent         = 10;
	fandisk10.meanRadiusRatio = 0.944;
	fandisk10.below30Percent  = 0.2;
	fandisk10.rmsPercent      = 0.0425;
	return {igea,   adapted,  facemask, laurana,   terrain,  iguana,  casting,   casting10,
			cheese, fullSize, doubled,  rockerarm, gargoyle, fandisk, fandisk20, fandisk10};
}

std::string bandName(const ::testing::TestParamInfo<Band>& info)
{
	std::string name = shortName(info.param.file) + "To" + std::to_string(int(info.param.percent));
	if (info.param.adapt > 0) name += "Adapted";
	return name;
}

INSTANTIATE_TEST_SUITE_P(, RealMesh, ::testing::ValuesIn(bands()), bandName);

/// A range map with ragged borders, which more than a third of the vertices lie on by default.
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
		EXPECT_EQ(facts.components, 39); // those of the repaired scan
		EXPECT_EQ(facts.boundaryLoops, 60);
		EXPECT_EQ(facts.euler(), 18);
		EXPECT_GE(r.report.quality.radiusRatioMean, 0.97);
		EXPECT_LE(r.report.border.cutArea, 0.02 * r.report.border.area);
		EXPECT_LE(r.report.border.resultLength, 0.72 * r.report.border.length);
		below30 += r.report.quality.below30Percent / 3;
	}
	EXPECT_LE(below30, 0.3); // 4.3 by default
}

/// Tunnels and walls thinner than the triangles, in models that do not intersect themselves.
struct ThinModel {
	const char* file;
	int         vertexNum;
	Preset      preset;
	double      adapt;
	double      leastRegularity;   ///< mean 2r/R
	int         mostInverted = 12; ///< faces
	double      farthest = 2.5; ///< distance of either surface from the other, in % of the diagonal
};

class ThinModels : public ::testing::TestWithParam<ThinModel> {};

TEST_P(ThinModels, DoNotIntersectThemselves)
{
	const ThinModel& thin  = GetParam();
	const ModelFile  model = findModel(thin.file);
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	const app::InputMesh input = app::readMesh(model.path);
	RemeshOptions        options;
	options.preset          = thin.preset;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = thin.vertexNum;
	options.adapt           = thin.adapt;
	options.threads         = 2;
	options.check           = true;
	const RemeshResult r    = remesh(input.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(int(r.mesh.vertexNum()), thin.vertexNum);
	EXPECT_LE(r.report.provenDistance.hausdorff().upper,
			  0.01 * thin.farthest * r.report.input.diagonal);
	EXPECT_TRUE(r.report.audit.passed);
	Workers workers(2, nullptr);
	EXPECT_TRUE(findTouchingPairs(halfEdgesOf(r.mesh), workers).empty());
	EXPECT_EQ(r.report.audit.guarded.inputPairNum, 0);
	EXPECT_LE(r.report.audit.invertedFaces, thin.mostInverted);
	EXPECT_LE(r.report.audit.guarded.vertexNum, thin.vertexNum / 5) << "only patches are made anew";
	EXPECT_GE(r.report.quality.radiusRatioMean, thin.leastRegularity);
}

INSTANTIATE_TEST_SUITE_P(
	, ThinModels,
	::testing::Values(ThinModel{"cad_adis_7k_genus24.stl", 2500, Preset::Default, 0, 0.91},
					  ThinModel{"cad_adis_7k_genus24.stl", 2500, Preset::Default, 1, 0.87},
					  ThinModel{"cad_adis_7k_genus24.stl", 2500, Preset::Fast, 0, 0.9},
					  ThinModel{"casting_10k_genus9.ply", 500, Preset::Default, 0, 0.85},
					  ThinModel{"casting_10k_genus9.ply", 500, Preset::Fast, 1, 0.77},
					  ThinModel{"ct_vessels_1.5M_1803comp.ply.gz", 75000, Preset::Default, 0.1, 0.9,
								1500, 1.3}), // a vessel of six edges was drawn together: 2.1 %
	[](const auto& one) {
		const ThinModel& thin = one.param;
		return shortName(thin.file) + (thin.preset == Preset::Fast ? "Fast" : "") +
			   (thin.adapt > 0 ? "Adapted" : "");
	});

/// An electronic part whose 104 faces have vertices of their own. Sewn it is one solid; before,
/// each was remeshed by itself and a third of all triangles had an angle below 30 degrees.
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

/// A tenth of a percent of the diagonal, proven, with no more vertices than this. Where few places
/// decide the count is twice as large with one seed as with another.
struct ErrorGoal {
	const char*  file;
	std::int64_t mostVertices;
};

std::ostream& operator<<(std::ostream& out, const ErrorGoal& goal)
{
	return out << goal.file;
}

class ErrorOfRealMesh : public ::testing::TestWithParam<ErrorGoal> {};

TEST_P(ErrorOfRealMesh, IsProvenToBeATenthOfAPercent)
{
	const ModelFile model = findModel(GetParam().file);
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	const app::InputMesh input = app::readMesh(model.path);
	RemeshOptions        options;
	options.targetMode        = TargetMode::MaxError;
	options.targetMaxError    = 0.1;
	options.maxErrorIsPercent = true;
	options.threads           = 2;
	const RemeshResult r      = remesh(input.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_LE(r.report.provenDistance.hausdorff().upper, r.report.errorGoal);
	EXPECT_LE(std::int64_t(r.mesh.vertexNum()), GetParam().mostVertices);
}

INSTANTIATE_TEST_SUITE_P(, ErrorOfRealMesh,
						 ::testing::Values(ErrorGoal{"casting_10k_genus9.ply", 10500},
										   ErrorGoal{"fandisk_13k_cad.ply", 3200},
										   ErrorGoal{"gargoyle_96k.ply", 37000},
										   ErrorGoal{"igea_269k.ply", 8600}),
						 [](const auto& goal) { return shortName(goal.param.file); });

/// The bunny of Debian's glmark2-data, which every checkout can install.
TEST(Bunny, StaysWithinItsBands)
{
	const std::string path = "/usr/share/glmark2/models/bunny.obj";
	if (!std::ifstream(path)) GTEST_SKIP() << "glmark2-data is not installed";
	Band bunny{"bunny.obj", 10};
	bunny.meanRadiusRatio = 0.983;
	bunny.meanAspectRatio = 0.94;
	bunny.minAngleDeg     = 31;
	bunny.below30Percent  = 0;
	bunny.valence6Percent = 89;
	bunny.rmsPercent      = 0.0435;
	expectWithin(path, bunny);
}

/// The paper as it is written. Its own Table 1 has 0.824 to 0.835 for the aspect ratio and lands 1
/// to 8 % below the target; ours lands 8 to 12 % below it.
class PaperPreset : public ::testing::TestWithParam<const char*> {};

TEST_P(PaperPreset, IsAsRegularAsThePapersTableAndMissesTheTargetByATenth)
{
	const ModelFile model = findModel(GetParam());
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	const app::InputMesh input = app::readMesh(model.path);
	RemeshOptions        options;
	options.preset       = Preset::Paper;
	options.threads      = 2;
	const RemeshResult r = remesh(input.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	const SurfaceFacts facts = factsOf(r.mesh);
	EXPECT_EQ(facts.components, r.report.cleanedInput.components);
	EXPECT_EQ(facts.boundaryLoops, r.report.cleanedInput.boundaryLoops);
	EXPECT_EQ(facts.euler(), r.report.cleanedInput.eulerCharacteristic);
	EXPECT_GE(r.report.quality.aspectRatioMean, 0.843);
	EXPECT_NEAR(double(r.mesh.vertexNum()) / double(r.report.targetVertexNum), 0.90, 0.025);
}

INSTANTIATE_TEST_SUITE_P(, PaperPreset,
						 ::testing::Values("igea_269k.ply", "gargoyle_96k.ply", "human_49k.ply",
										   "facemask_62k_open.ply", "laurana_50k_colour_open.ply"),
						 [](const auto& file) { return shortName(file.param); });

/// Models that are no manifold: repaired, counted, and a sound result.
class RealDefects : public ::testing::TestWithParam<const char*> {};

TEST_P(RealDefects, AreRepairedAndCounted)
{
	const ModelFile model = findModel(GetParam());
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	const app::InputMesh input = app::readMesh(model.path);
	RemeshOptions        options;
	options.targetPercent = 30;
	options.threads       = 2;
	const RemeshResult r  = remesh(input.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_TRUE(r.report.cleaned.changedInput());
	EXPECT_EQ(factsOf(r.mesh).components, r.report.cleanedInput.components);
}

INSTANTIATE_TEST_SUITE_P(, RealDefects,
						 ::testing::Values("abominevole_51k_nonmanifold.off",
										   "motorbike_332k_nonmanifold.ply",
										   "triple_vierbein_nonmanifold_edges.obj",
										   "hourglass_nonmanifold_vertex.obj"),
						 [](const auto& file) { return shortName(file.param); });

} // namespace

} // namespace gpr::test
