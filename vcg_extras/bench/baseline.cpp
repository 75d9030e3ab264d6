// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// gpr_bench_baseline: runs another simplifier on a file, as a program, for measurements from
// outside. Prints its own seconds and the figures of the result as JSON.
#include "baseline_cgal.h"
#include "baseline_meshoptimizer.h"

#include <vcg_extras/apps/gpremesh/compare/baseline_remeshers.h>
#include <vcg_extras/io/base/run_limit.h>
#include <vcg_extras/io/mesh_io.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

namespace {

using namespace gpr;

constexpr const char* usage = "usage: gpr_bench_baseline quadric|meshoptimizer|cgal IN OUT FACES\n";

app::BaselineResult simplified(const std::string& method, const std::string& in,
							   std::int64_t faceNum)
{
	const app::InputMesh mesh = app::readMesh(in);
	if (method == "meshoptimizer") return bench::simplifyByMeshoptimizer(mesh, faceNum);
	if (method == "cgal") return bench::remeshByCgal(mesh, faceNum);
	return app::collapseQuadricEdges(mesh.view(), faceNum, [] { return false; });
}

void run(const std::string& method, const std::string& in, const std::string& out,
		 std::int64_t faceNum)
{
	const app::BaselineResult result = simplified(method, in, faceNum);
	if (!result.failure.empty()) throw std::runtime_error(result.failure);
	app::MeshAttributes none;
	app::writeMesh(result.mesh, false, none, out, app::RunLimit());
	std::printf("{\"seconds\": %.6f, \"vertices\": %zu, \"faces\": %zu}\n", result.seconds,
				result.mesh.vertexNum(), result.mesh.faceNum());
}

} // namespace

int main(int argc, char** argv)
{
	const std::string method  = argc == 5 ? argv[1] : "";
	const long long   faceNum = argc == 5 ? std::atoll(argv[4]) : 0;
	if ((method != "quadric" && method != "meshoptimizer" && method != "cgal") || faceNum < 1) {
		std::fputs(usage, stderr);
		return 2;
	}
	try {
		run(method, argv[2], argv[3], faceNum);
	}
	catch (const std::exception& error) {
		std::fprintf(stderr, "gpr_bench_baseline: %s\n", error.what());
		return 1;
	}
	return 0;
}
