// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the mesh between the stages of a run, for pictures of the stages.
#include "staged_run.h"

#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh_io.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace gpr;

const char* const usage =
	"gpr_stage_meshes IN PERCENT DIR\n\n"
	"Remeshes IN to PERCENT % of its vertices, all of one size, and writes the mesh after each\n"
	"stage: DIR/retriangulated.off, flipped.off, counted.off, repaired.off and fitted.off.\n";

TriangleMesh inCallersUnit(const ResultMesh& result, const Frame& frame)
{
	TriangleMesh mesh;
	for (int v = 0; v < result.mesh.vertexNum; ++v)
		mesh.positions.push_back(frame.toCaller(result.mesh.position[v]));
	for (int h = 0; h < 3 * result.mesh.faceNum; ++h)
		mesh.triangles.push_back(result.mesh.origin[h]);
	return mesh;
}

void writeStages(const std::string& in, double percent, const std::string& folder)
{
	const app::InputMesh input = app::readMesh(in);
	RemeshOptions        options;
	options.targetPercent = percent;
	options.adapt         = 0;
	bench::StagedRun run(input.view(), options);
	const Products&  made  = run.sampled();
	const auto       write = [&](const char* name, const ResultMesh& result) {
        app::OutputFile out(folder + "/" + name + ".off");
        app::writeOff(inCallersUnit(result, made.surface.frame), false, out);
        out.commit();
	};
	Workers workers(0, nullptr);
	write("retriangulated", removeVertices(made.surface, made.samples.sampling, made.samples.curves,
										   made.surface.figures, workers));
	write("flipped", run.improved().flipped);
	write("counted", run.improved().counted);
	write("repaired", run.improved().repaired);
	write("fitted", run.improved().fitted);
}

} // namespace

int main(int argc, char** argv)
{
	if (argc != 4) {
		std::fputs(usage, stderr);
		return 2;
	}
	try {
		writeStages(argv[1], std::atof(argv[2]), argv[3]);
	}
	catch (const std::exception& error) {
		std::fprintf(stderr, "gpr_stage_meshes: %s\n", error.what());
		return 1;
	}
	return 0;
}
