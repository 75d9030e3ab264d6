// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The paper's feature preservation on a CAD part and on a scan, without feature lines: the crease
// edges of the input come nearer to the result (§3.1.1 manual, §3.1.2 automatic). Skipped without
// GPR_MODELS_DIR.

#include <tests/support/mesh_audit.h>
#include <tests/support/model_files.h>
#include <tests/support/oracles.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/io/mesh_io.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

struct Model {
	const char* file;
	double      lambda, disks, vertices; ///< largest shares of the distance without preservation
};

std::ostream& operator<<(std::ostream& out, const Model& model)
{
	return out << model.file;
}

class FeaturePreservation : public ::testing::TestWithParam<Model> {
protected:
	RemeshOptions            options;
	TriangleMesh             mesh;
	std::vector<FeatureEdge> features;

	void SetUp() override
	{
		const ModelFile model = findModel(GetParam().file);
		if (!model.isThere()) GTEST_SKIP() << model.missing;
		mesh                  = triangleMeshOf(app::readMesh(model.path).view());
		options.targetPercent = 20;
		features              = detectFeatures(mesh.view(), options).edges;
		options.featureMode   = FeatureMode::Off;
		options.threads       = 2;
	}

	/// Root mean square distance from the ends and middles of crease edges to the result.
	double distance() const
	{
		const RemeshResult r = remesh(mesh.view(), options);
		EXPECT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
		double sum = 0;
		for (const FeatureEdge& e : features) {
			const Vec3d a = mesh.positions[e.vertex[0]], b = mesh.positions[e.vertex[1]];
			for (const Vec3d& p : {a, b, (a + b) * 0.5})
				sum += std::pow(distanceToMesh(r.mesh, p), 2);
		}
		return std::sqrt(sum / (3.0 * double(features.size())));
	}
};

TEST_P(FeaturePreservation, BringsTheResultNearerToSharpEdges)
{
	ASSERT_GT(features.size(), 700u);
	options.adapt = 0; // sizes by the error also lower the distance
	for (const Preset preset : {Preset::Fast, Preset::Default}) {
		options.preset        = preset;
		options.featureRegion = FeatureRegion::None;
		const double none     = distance();
		options.lambda        = 2;
		EXPECT_LE(distance(), GetParam().lambda * none);
		options.lambda        = 0;
		options.featureRegion = FeatureRegion::Detected;
		EXPECT_LE(distance(), GetParam().disks * none);
	}
}

/// The paper's other way: each vertex of the region is kept.
TEST_P(FeaturePreservation, KeepsSharpEdgesWithThePaper)
{
	options.preset        = Preset::Paper;
	options.featureRegion = FeatureRegion::None;
	const double none     = distance();
	options.featureRegion = FeatureRegion::Detected;
	EXPECT_LE(distance(), GetParam().vertices * none);
}

INSTANTIATE_TEST_SUITE_P(, FeaturePreservation,
						 ::testing::Values(Model{"fandisk_13k_cad.ply", 0.95, 0.7, 0.001},
										   Model{"rockerarm_20k.ply", 0.95, 0.75, 0.75}),
						 [](const auto& model) { return shortName(model.param.file); });

} // namespace

} // namespace gpr::test
