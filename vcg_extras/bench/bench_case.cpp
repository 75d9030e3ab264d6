// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_case.h"

#include "built_in_meshes.h"

#include <vcg_extras/io/mesh_io.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <sstream>

namespace gpr::bench {

namespace {

struct BuiltIn {
	const char*  kind;
	const char*  size;
	std::int64_t faceNum;
};

constexpr BuiltIn builtIns[] = {
	{"stone", "100k", 100000}, {"stone", "400k", 400000}, {"stone", "1600k", 1600000},
	{"land", "400k", 400000},  {"box", "400k", 400000},
};

app::InputMesh inputOf(const TriangleMesh& mesh)
{
	app::InputMesh input;
	for (const Vec3d& p : mesh.positions)
		for (const double c : {p.x, p.y, p.z})
			input.floats.push_back(float(c));
	input.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
	return input;
}

BenchMesh builtInMesh(const BuiltIn& wanted)
{
	return {std::string(wanted.kind) + "_" + wanted.size, [wanted] {
				TriangleMesh mesh;
				makeBuiltIn(wanted.kind, wanted.faceNum, mesh);
				return inputOf(mesh);
			}};
}

/// The last mesh and run: benchmarks on the same mesh follow each other.
class LastRun {
public:
	StagedRun& runOn(const BenchCase& on)
	{
		if (!input_ || on.mesh.name != name_) {
			run_.reset();
			input_ = std::make_unique<app::InputMesh>(on.mesh.make());
			name_  = on.mesh.name;
		}
		if (!run_ || on.graded != graded_) {
			RemeshOptions options;
			options.adapt = on.graded ? 1 : 0;
			graded_       = on.graded;
			run_.reset();
			run_ = std::make_unique<StagedRun>(input_->view(), options);
		}
		return *run_;
	}

private:
	std::string                     name_;
	bool                            graded_ = false;
	std::unique_ptr<app::InputMesh> input_;
	std::unique_ptr<StagedRun>      run_;
};

} // namespace

std::vector<BenchMesh> benchMeshes()
{
	std::vector<BenchMesh> meshes;
	for (const BuiltIn& wanted : builtIns)
		meshes.push_back(builtInMesh(wanted));
	const char*        files = std::getenv("GPR_BENCH_MESHES");
	std::istringstream list(files != nullptr ? files : "");
	for (std::string path; std::getline(list, path, ':');) {
		if (path.empty()) continue;
		meshes.push_back(
			{std::filesystem::path(path).stem().string(), [path] { return app::readMesh(path); }});
	}
	return meshes;
}

void addBenchmark(const std::string& stage, const BenchCase& on, const StageBenchmark& stageBody)
{
	static LastRun    last;
	const std::string name = stage + "/" + on.mesh.name + (on.graded ? "/graded" : "/uniform") +
							 "/threads:" + std::to_string(on.threads);
	const auto body = [on, stageBody](benchmark::State& state) {
		try {
			StagedRun& run = last.runOn(on);
			Workers    workers(on.threads, nullptr);
			stageBody(state, run, workers);
			state.SetItemsProcessed(state.iterations() * std::int64_t(run.input().faceNum));
		}
		catch (const std::exception& error) {
			state.SkipWithError(error.what());
		}
	};
	benchmark::RegisterBenchmark(name.c_str(), body)
		->UseManualTime()
		->Unit(benchmark::kMillisecond);
}

} // namespace gpr::bench
