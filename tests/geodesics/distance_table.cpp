// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints vcg_extras/docs/accuracy_of_distances.md, with the models of GPR_MODELS_DIR where it is
// set:
//
//   GPR_MODELS_DIR=... build/bin/gpr_distance_table > vcg_extras/docs/accuracy_of_distances.md
#include "distance_accuracy.h"
#include "distance_cases.h"

#include <vcg_extras/apps/gpremesh/mesh_io.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace {

using namespace gpr::test;

constexpr int           sourceNum = 40;
constexpr std::uint32_t seed      = 1;

void printRows(const DistanceCase& c, const gpr::MeshView& mesh)
{
	const Ground ground(mesh, c.percent);
	for (Metric metric : {Metric::Default, Metric::BorderEdge}) {
		for (double reach : {1.0, 2.0}) {
			const Accuracy a = measureAccuracy(ground, metric, reach, sourceNum, seed);
			std::printf("| %s | %s | %g r | %lld | %.2f %% | +%.1f %% | %.1f %% | %.2f %% |\n",
						c.words.c_str(), metric == Metric::Default ? "default" : "border edges",
						reach, static_cast<long long>(a.vertexNum), 100 * a.mean,
						100 * a.largestOver, 100 * a.largestUnder, 100 * a.above5Percent);
		}
	}
}

const char* const intro =
	"<!-- Made by build/bin/gpr_distance_table (tests/geodesics); do not edit. -->\n"
	"# How true the distances are\n"
	"\n"
	"The sampling floods the surface from each sample with distances that are to be geodesic "
	"(paper "
	"§3, step 3). Here they\n"
	"are held against exact geodesics of the same polyhedron (CGAL's Surface_mesh_shortest_path), "
	"from %d random points of\n"
	"each surface, at all vertices within r and within 2 r, r being the disk radius for a target "
	"of 10 %% of the vertices\n"
	"(2 %% for the coarse torus). Relative errors: +1 %% is a hundredth too long.\n"
	"\n"
	"- **default**: the placement by disk intersection. Chords, lengthened for the bend, where all "
	"normals of the disk are\n"
	"  within 37° of its middle's; triangles unfolded elsewhere. Noise shortens chords, so that "
	"they are too short there.\n"
	"- **border edges**: the paper's placement. Triangles unfolded everywhere.\n"
	"\n"
	"| surface | metric | up to | vertices | mean error | longest | shortest | off by more than 5 "
	"%% "
	"|\n"
	"|---|---|---|---:|---:|---:|---:|---:|\n";

const char* const outro =
	"\n"
	"The largest errors are at the end of a disk (a vertex within it whose straight way runs over "
	"one outside) and behind\n"
	"hollow corners (unfolding sees the source where the front would have come from, not the "
	"corner it went round).\n"
	"A vertex is visited again when a way turns up that is shorter by a thousandth: at obtuse and "
	"right angles the triangle\n"
	"that holds the straight way may be settled after the vertex it leads to.\n"
	"Bands that fail: `tests/geodesics/distance_accuracy_test.cpp`.\n";

} // namespace

int main()
{
	std::printf(intro, sourceNum);
	for (const DistanceCase& c : madeDistanceCases())
		printRows(c, c.mesh.view());
	const char* folder = std::getenv("GPR_MODELS_DIR");
	for (const DistanceCase& c : modelDistanceCases()) {
		if (folder == nullptr) break;
		const std::string path = std::string(folder) + "/" + c.name + ".ply";
		if (std::ifstream(path)) printRows(c, gpr::app::readMesh(path).view());
	}
	std::printf("%s", outro);
	return 0;
}
