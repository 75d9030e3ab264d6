// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every model of the folder GPR_MODELS_DIR: within the time limit a valid result or, if the model
// may be refused, a refusal with a sentence. Skipped without the variable.
#include "program_runner.h"
#include "surface_check.h"

#include <cstdlib>
#include <filesystem>
#include <set>

namespace gpr_test {

/// Ten times the time of the slowest model on a quiet machine: needles whose whole mesh is made
/// anew because of self-intersections.
constexpr int maxSeconds = 280;

namespace {

enum class Duty { MustRemesh, MayRefuse };

struct Model {
	const char* file;
	Duty        duty;
};

std::ostream& operator<<(std::ostream& out, const Model& m)
{
	return out << m.file;
}

const Model models[] = {
	{"nasty/duplicate_and_opposite_faces.ply", Duty::MustRemesh},
	{"nasty/dust_10000_components.ply", Duty::MustRemesh},
	{"nasty/fins_nonmanifold_edges.ply", Duty::MustRemesh},
	{"nasty/flat_z0.ply", Duty::MustRemesh},
	{"nasty/huge_scale_1e9.ply", Duty::MustRemesh},
	{"nasty/isolated_vertices_500.ply", Duty::MustRemesh},
	{"nasty/moebius_strip.ply", Duty::MustRemesh},
	{"nasty/nan_inf_vertices.ply", Duty::MustRemesh},
	{"nasty/needle_scale_x1000.ply", Duty::MustRemesh},
	{"nasty/negative_indices_quads_ngons.obj", Duty::MustRemesh},
	{"nasty/pinched_nonmanifold_vertices.ply", Duty::MustRemesh},
	{"nasty/plate_two_huge_triangles.ply", Duty::MustRemesh},
	{"nasty/random_orientation.ply", Duty::MustRemesh},
	{"nasty/single_triangle.off", Duty::MustRemesh},
	{"nasty/soup_almost_welded.ply", Duty::MustRemesh},
	{"nasty/stray_huge_triangles_and_holes.ply", Duty::MustRemesh},
	{"nasty/tetrahedron.off", Duty::MustRemesh},
	{"nasty/tiny_scale_1e-9.ply", Duty::MustRemesh},
	{"nasty/two_triangles_sharing_vertex.off", Duty::MustRemesh},
	{"nasty/utm_offset_double.ply", Duty::MustRemesh},
	{"nasty/utm_offset_float.ply", Duty::MustRemesh},
	{"nasty/all_degenerate.ply", Duty::MayRefuse},
	{"nasty/empty_0byte.ply", Duty::MayRefuse},
	{"nasty/endless_header.ply", Duty::MayRefuse},
	{"nasty/garbage_text.ply", Duty::MayRefuse},
	{"nasty/header_only_0faces.ply", Duty::MayRefuse},
	{"nasty/index_out_of_range.ply", Duty::MayRefuse},
	{"nasty/klein_bottle.ply", Duty::MayRefuse},
	{"nasty/points_only.ply", Duty::MayRefuse},
	{"nasty/truncated_mid_faces.ply", Duty::MayRefuse},
	{"nasty/truncated_mid_vertices.ply", Duty::MayRefuse},
	{"nasty/zero_area_plane_collapsed.ply", Duty::MayRefuse},
	{"abominevole_51k_nonmanifold.off", Duty::MustRemesh},
	{"triple_vierbein_nonmanifold_edges.obj", Duty::MustRemesh},
	{"hourglass_nonmanifold_vertex.obj", Duty::MustRemesh},
	{"conrod_6k_bad_orientation.stl", Duty::MustRemesh},
	{"self_intersecting_17k.obj", Duty::MustRemesh},
	{"office_chair_7k_quads_degenerate.obj", Duty::MustRemesh},
	{"counter_84k_cad_soup_grading.stl", Duty::MustRemesh},
	{"motorbike_332k_nonmanifold.ply", Duty::MustRemesh},
	{"igea_269k_tristrips.ply", Duty::MustRemesh},
	{"bunny10k_uv_open.obj", Duty::MustRemesh},
};

/// The folder; empty without the variable.
std::string modelsFolder()
{
	const char* const folder = std::getenv("GPR_MODELS_DIR");
	return folder == nullptr ? "" : folder;
}

const char* const skipLine = "GPR_MODELS_DIR is not set: the models are not tested";

} // namespace

class Models : public CliTest, public ::testing::WithParamInterface<Model> {};

TEST_P(Models, ResultIsValidOrRefusedWithASentence)
{
	if (modelsFolder().empty()) GTEST_SKIP() << skipLine;
	const std::string in = modelsFolder() + "/" + GetParam().file;
	if (!exists(in)) GTEST_SKIP() << in << " is missing";
	const ProgramResult result = run({"remesh", in, path("out.ply")}, maxSeconds);
	EXPECT_LT(result.seconds, maxSeconds);
	if (result.exitCode == 0) {
		std::string precision;
		expectManifold(parseWrittenPly(content(path("out.ply")), precision));
		return;
	}
	ASSERT_EQ(GetParam().duty, Duty::MayRefuse) << result.exitCode << ": " << result.err;
	expectFailure(result, result.exitCode == 4 ? 4 : 3);
	EXPECT_FALSE(exists(path("out.ply")));
}

INSTANTIATE_TEST_SUITE_P(Folder, Models, ::testing::ValuesIn(models), [](const auto& test) {
	std::string name = std::filesystem::path(test.param.file).stem().string();
	for (char& c : name) {
		if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
	}
	return name;
});

TEST(ModelsFolder, EveryNastyFileIsInTheTable)
{
	if (modelsFolder().empty()) GTEST_SKIP() << skipLine;
	std::set<std::string> known;
	for (const Model& m : models)
		known.insert(m.file);
	for (const auto& entry : std::filesystem::directory_iterator(modelsFolder() + "/nasty")) {
		EXPECT_EQ(known.count("nasty/" + entry.path().filename().string()), 1u) << entry.path();
	}
}

} // namespace gpr_test
