// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// From the file to the surface.
#include "bench_case.h"

#include <vcg_extras/core/features/crease_lines.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/spatial_order.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh_io.h>

#include <cstdio>
#include <filesystem>

namespace gpr::bench {

namespace {

/// A temporary PLY file, removed at the end.
class ScratchFile {
public:
	ScratchFile() :
			path_((std::filesystem::temp_directory_path() /
				   ("gpremesh_bench_" + std::to_string(app::processId()) + ".ply"))
					  .string())
	{
	}
	~ScratchFile() { std::remove(path_.c_str()); }
	ScratchFile(const ScratchFile&)            = delete;
	ScratchFile& operator=(const ScratchFile&) = delete;

	const std::string& path() const { return path_; }
	void               write(const MeshView& mesh) const
	{
		app::OutputFile out(path_);
		app::writePly(mesh, false, app::MeshAttributes(), out);
		out.commit();
	}

private:
	std::string path_;
};

struct OrderedMesh {
	IndexedMesh mesh;
	Buffer<int> faceStart;
	MortonGrid  grid;
};

OrderedMesh loaded(StagedRun& run, Workers& workers)
{
	CleanCounts counts;
	return {loadInput(run.input(), workers, counts), Buffer<int>(), MortonGrid()};
}

OrderedMesh ordered(StagedRun& run, Workers& workers)
{
	OrderedMesh o = loaded(run, workers);
	o.grid        = orderSpatially(o.mesh, workers, o.faceStart);
	return o;
}

void readPlyFile(benchmark::State& state, StagedRun& run, Workers&)
{
	const ScratchFile file;
	file.write(run.input());
	timeEach(state, [&] { return app::readMesh(file.path()); });
}

void writePlyFile(benchmark::State& state, StagedRun& run, Workers&)
{
	const ScratchFile file;
	timeEach(state, [&] {
		file.write(run.input());
		return 0;
	});
}

void load(benchmark::State& state, StagedRun& run, Workers& workers)
{
	timeEach(state, [&] { return loaded(run, workers); });
}

void order(benchmark::State& state, StagedRun& run, Workers& workers)
{
	timeEach(
		state, [&] { return loaded(run, workers); },
		[&](OrderedMesh& o) { return orderSpatially(o.mesh, workers, o.faceStart); });
}

void halfEdgeTable(benchmark::State& state, StagedRun& run, Workers& workers)
{
	timeEach(
		state, [&] { return ordered(run, workers); },
		[&](OrderedMesh& o) {
			Surface surface;
			connect(o.mesh, o.faceStart, workers, surface);
			return surface;
		});
}

void figures(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const HalfEdgeMesh& mesh = run.sampled().surface.mesh;
	timeEach(state, [&] { return figuresOf(mesh, 1, workers); });
}

/// Load, split, order, connect, sizes and figures in one.
void prepareAll(benchmark::State& state, StagedRun& run, Workers& workers)
{
	timeEach(state, [&] { return run.runUntil(Step::Lines, workers.threadNum()); });
}

/// By the rules of a run with FeatureMode::Auto.
void creaseLines(benchmark::State& state, StagedRun& run, Workers& workers)
{
	const Products& p = run.sampled();
	CreaseRules     rules;
	rules.minLength = 3 * idealEdge(p, run.decisions().vertexNum);
	rules.minSpur   = idealEdge(p, run.decisions().vertexNum);
	Surface surface = copyOf(p.surface, workers);
	timeEach(
		state,
		[&] {
			surface.mesh.crease.release();
			return 0;
		},
		[&](int) { return markCreases(rules, workers, surface); });
}

} // namespace

void addInputBenchmarks(const BenchCase& on)
{
	if (!on.graded) {
		addBenchmark("read_ply", on, readPlyFile);
		addBenchmark("write_ply", on, writePlyFile);
		addBenchmark("load", on, load);
		addBenchmark("order", on, order);
		addBenchmark("half_edge_table", on, halfEdgeTable);
		addBenchmark("figures", on, figures);
	}
	addBenchmark("prepare", on, prepareAll);
	addBenchmark("crease_lines", on, creaseLines);
}

} // namespace gpr::bench
