// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints vcg_extras/docs/measurements_options.md: the effects of single options on triangles and
// distances.
//
//   GPR_MODELS_DIR=... build/bin/gpr_option_table COMMIT > vcg_extras/docs/measurements_options.md
//
// Needs the bunny of Debian's package glmark2-data, and takes all models in GPR_MODELS_DIR;
// vcg_extras/docs/models.md has their sources.
#include <tests/support/model_files.h>
#include <tests/support/oracles.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/surface/distance_histogram.h>
#include <vcg_extras/core/surface/surface_distance.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace gpr;

constexpr double       sharpDeg        = 40; ///< of crease edges to be preserved
constexpr std::int64_t distanceSamples = 400000;

struct Model {
	std::string  name;
	TriangleMesh mesh;
};

/// A name for the table, and its options.
struct Setting {
	std::string   name;
	RemeshOptions options;
};

RemeshOptions percentOptions(double percent)
{
	RemeshOptions options;
	options.targetPercent = percent;
	options.threads       = 2;
	return options;
}

/// The larger of both ways, in percent of the input's diagonal.
SurfaceDistance distanceBetween(const TriangleMesh& input, const TriangleMesh& result)
{
	Workers              workers(2, nullptr);
	const MutualDistance distance = {
		MeasuredSurface(input.view(), workers).from(result.view(), distanceSamples, workers),
		MeasuredSurface(result.view(), workers).from(input.view(), distanceSamples, workers)};
	return distance.larger().times(100 / measureMesh(input.view()).diagonal);
}

/// Distances from the input's crease edges, by ends and middles, to the result, in units of the
/// input.
SurfaceDistance distanceOfSharpEdges(const TriangleMesh& input, const TriangleMesh& result)
{
	const std::vector<Vec3d> ends = test::sharpSegments(input, sharpDeg);
	SurfaceDistance          d;
	DistanceHistogram        histogram;
	double                   sum = 0, num = 0;
	const auto               look = [&](const Vec3d& p) {
        const double off = test::distanceToMesh(result, p);
        sum += off * off;
        ++num;
        d.max = std::max(d.max, off);
        histogram.add(off);
	};
	for (std::size_t s = 0; s < ends.size(); s += 2) {
		look(ends[s]);
		look(ends[s + 1]);
		look((ends[s] + ends[s + 1]) * 0.5);
	}
	d.rms  = std::sqrt(sum / std::max(num, 1.0));
	d.p999 = histogram.p999(d.max);
	return d.times(100 / measureMesh(input.view()).diagonal);
}

RemeshResult remeshed(const Model& model, const Setting& setting)
{
	RemeshResult r = remesh(model.mesh.view(), setting.options);
	if (r.status == Status::Ok) return r;
	std::fprintf(stderr, "%s, %s: %s\n", model.name.c_str(), setting.name.c_str(),
				 r.message.c_str());
	std::exit(1);
}

// ---- the tables

std::vector<Setting> presetSettings()
{
	Setting fast{"fast", percentOptions(10)}, usual = fast, adapted = fast;
	fast.options.preset   = Preset::Fast;
	usual.name            = "default";
	adapted.name          = "default, with `--adapt 1`";
	adapted.options.adapt = 1;
	return {fast, usual, adapted};
}

void printPresets(const std::vector<Model>& models)
{
	std::printf("## Preset and adaptivity\n\n10 %% of the vertices.\n\n| model | `--preset` | root "
				"mean square distance | p99.9 | largest distance | vertices with six neighbours | "
				"mean 2r/R | mean aspect ratio | smallest angle "
				"|\n|---|---|---:|---:|---:|---:|---:|---:|---:|\n");
	for (const Model& model : models) {
		for (const Setting& setting : presetSettings()) {
			const RemeshResult    r = remeshed(model, setting);
			const QualityFigures& q = r.report.quality;
			const SurfaceDistance d = distanceBetween(model.mesh, r.mesh);
			std::printf(
				"| %s | %s | %.4f %% | %.3f %% | %.3f %% | %.1f %% | %.4f | %.3f | %.1f° |\n",
				model.name.c_str(), setting.name.c_str(), d.rms, d.p999, d.max, q.valence6Percent,
				q.radiusRatioMean, q.aspectRatioMean, q.minAngleDeg);
		}
	}
}

std::vector<Setting> lineSettings()
{
	std::vector<Setting> settings = {{"auto", percentOptions(10)}};
	for (int angle : {40, 60, 80, 100}) {
		Setting lines             = {"lines, with `--feature-angle " + std::to_string(angle) + "`",
									 percentOptions(10)};
		lines.options.featureMode = FeatureMode::Lines;
		lines.options.featureAngleDeg = angle;
		settings.push_back(lines);
	}
	return settings;
}

void printLines(const Model& scan)
{
	std::printf("\n## Feature lines on a scan\n\n10 %% of the vertices of the bunny. Its ears have "
				"sharp rims.\n\n| `--features` | edges of the input on lines | root mean square "
				"distance | p99.9 | largest distance | smallest angle | inverted faces "
				"|\n|---|---:|---:|---:|---:|---:|---:|\n");
	for (const Setting& setting : lineSettings()) {
		const RemeshResult    r = remeshed(scan, setting);
		const SurfaceDistance d = distanceBetween(scan.mesh, r.mesh);
		std::printf("| %s | %lld | %.4f %% | %.3f %% | %.3f %% | %.1f° | %lld |\n",
					setting.name.c_str(), static_cast<long long>(r.report.featureEdgeNum), d.rms,
					d.p999, d.max, r.report.quality.minAngleDeg,
					static_cast<long long>(r.report.audit.invertedFaces));
	}
}

std::vector<Setting> preservationSettings(Preset preset)
{
	Setting none{"none", percentOptions(20)};
	none.options.preset      = preset;
	none.options.featureMode = FeatureMode::Off;
	Setting lambda = none, disks = none, kept = none;
	lambda.name                    = "`--lambda 2`";
	lambda.options.lambda          = 2;
	disks.name                     = "`--feature-region detected --feature-disk-scale 0.5`";
	disks.options.featureRegion    = FeatureRegion::Detected;
	disks.options.featureDiskScale = 0.5;
	kept.name                      = "`--feature-region detected`: each vertex is kept";
	kept.options.featureRegion     = FeatureRegion::Detected;
	// The paper's density depends on the mesh's unit.
	if (preset == Preset::Paper) return {none, disks, kept};
	return {none, lambda, disks};
}

void printPreservation(const std::vector<Model>& models)
{
	std::printf(
		"\n## Preserving features\n\n20 %% of the vertices with `--features off`. Distances "
		"from edges of the input sharper than %g° to the surface of the result.\n\n| "
		"model | `--preset` | options | root mean square distance | p99.9 | largest distance | "
		"mean "
		"2r/R |\n|---|---|---|---:|---:|---:|---:|\n",
		sharpDeg);
	for (const Model& model : models) {
		for (const auto& [preset, name] :
			 {std::pair(Preset::Default, "default"), std::pair(Preset::Fast, "fast"),
			  std::pair(Preset::Paper, "paper")}) {
			for (const Setting& setting : preservationSettings(preset)) {
				const RemeshResult    r = remeshed(model, setting);
				const SurfaceDistance d = distanceOfSharpEdges(model.mesh, r.mesh);
				std::printf("| %s | %s | %s | %.3f %% | %.2f %% | %.2f %% | %.4f |\n",
							model.name.c_str(), name, setting.name.c_str(), d.rms, d.p999, d.max,
							r.report.quality.radiusRatioMean);
			}
		}
	}
}

// ---- the page

const char* const intro =
	"<!-- Made by build/bin/gpr_option_table (tests/docs); do not edit. -->\n"
	"# Effect of options\n"
	"\n"
	"All other options have their defaults, seed 1. Distances are sampled and in percent of the "
	"diagonal of the bounding box of the input: the larger of the\n"
	"two root mean squares, the larger of the two p99.9, and the largest of all. 99.9 %% of the "
	"points are nearer than p99.9; the largest\n"
	"distance depends on a single point, and varies much with the seed. 2r/R and aspect ratio are "
	"1 for an equilateral triangle.\n"
	"[Sources of the models](models.md). Commit %s.\n"
	"\n";

/// The models of the list in the models' folder.
std::vector<Model> modelsOf(const std::vector<std::string>& names)
{
	std::vector<Model> models;
	const char*        folder = std::getenv("GPR_MODELS_DIR");
	for (const std::string& name : names) {
		if (folder == nullptr) break;
		const std::string path = std::string(folder) + "/" + name + ".ply";
		if (std::ifstream(path))
			models.push_back({name, triangleMeshOf(app::readMesh(path).view())});
	}
	return models;
}

} // namespace

int main(int argc, char** argv)
{
	const Model bunny = {
		"bunny", triangleMeshOf(app::readMesh("/usr/share/glmark2/models/bunny.obj").view())};
	std::vector<Model>       scans = modelsOf({"igea_269k"});
	const std::vector<Model> parts = modelsOf({"fandisk_13k_cad", "rockerarm_20k"});
	scans.insert(scans.begin(), bunny);
	std::vector<Model> all = scans;
	all.insert(all.end(), parts.begin(), parts.end());
	std::printf(intro, argc > 1 ? argv[1] : "unknown");
	printPresets(all);
	printLines(bunny);
	printPreservation(parts);
	return 0;
}
