// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints vcg_extras/docs/accuracy_of_distances.md, with the models of GPR_MODELS_DIR if set:
//
//   GPR_MODELS_DIR=... build/bin/gpr_distance_table > vcg_extras/docs/accuracy_of_distances.md
#include "distance_accuracy.h"
#include "distance_cases.h"

#include <vcg_extras/io/mesh_io.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace {

using namespace gpr::test;

constexpr int           sourceNum = 40;
constexpr std::uint32_t seed      = 1;

const char* const intro =
	"<!-- Made by build/bin/gpr_distance_table (tests/geodesics); do not edit. -->\n"
	"# Accuracy of distances\n"
	"\n"
	"The sampling floods the surface from each sample (paper §3, step 3). The distances of a flood "
	"should be geodesic. This page compares these\n"
	"distances with exact geodesics of the same polyhedron, by CGAL's Surface_mesh_shortest_path. "
	"The sources are %d random points of each\n"
	"surface. The table covers all vertices within r and within 2 r of a source; r is the disk "
	"radius for 10 %% of the vertices (2 %% for the\n"
	"coarse torus). Errors are relative: +1 %% is too long by a hundredth. The program makes the "
	"surfaces. igea and fandisk are\n"
	"[public models](models.md).\n"
	"\n"
	"- **default** is the placement by disk intersection. A way is straight as long as the normals "
	"stay within 37° of the normal at its begin: its\n"
	"  length is the chord, lengthened for the bend. Beyond, triangles are unfolded. Among short "
	"edges a way goes on straight from the edge that\n"
	"  it crosses. Chords are too short on a noisy surface, and across grooves.\n"
	"- **border edges** is the placement of the paper. Triangles are always unfolded.\n"
	"\n"
	"| surface | metric | up to | vertices | mean error | longest | shortest | off by more than 5 "
	"%% "
	"|\n"
	"|---|---|---|---:|---:|---:|---:|---:|\n";

const char* const afterTable =
	"\n"
	"The largest errors are in two places. The first place is the end of a disk, at a vertex "
	"inside whose straight way runs over a vertex outside. The\n"
	"second place lies behind hollow corners: unfolding measures from the direction of the front, "
	"not from the corner on the shortest way. At\n"
	"obtuse and right angles the triangle on the straight way may be reached after the vertex. A "
	"vertex is therefore visited again if a\n"
	"way turns up that is shorter by a thousandth.\n"
	"\n"
	"## Distances under a density\n"
	"\n"
	"With λ above 0 the placement of the paper stretches distances, eq. (4). Each edge is longer "
	"by the mean stretch of its ends. An unfolded triangle\n"
	"has three edges that are longer by the mean stretch of its corners, and vertices are visited "
	"again as above. The stretch 1 / y turns\n"
	"the plane into the hyperbolic plane, whose distances have a closed form. The table uses "
	"jittered grids over [0, 1] × [0.25, 1], %d random\n"
	"points each, and disks inside the grid. Radii are hyperbolic lengths. \"Edges\" is the radius "
	"in edges of the grid, at the height of stretch 2.\n"
	"\n"
	"| cells of the grid | radius | edges | vertices | mean error | longest | shortest | off by "
	"more "
	"than 5 %% |\n"
	"|---|---:|---:|---:|---:|---:|---:|---:|\n";

const char* const outro = "\n"
						  "Limits of the tests: `tests/geodesics/distance_accuracy_test.cpp`.\n";

void printFigures(const Accuracy& a)
{
	std::printf("%lld | %.2f %% | +%.1f %% | %.1f %% | %.2f %% |\n",
				static_cast<long long>(a.vertexNum), 100 * a.mean, 100 * a.largestOver,
				100 * a.largestUnder, 100 * a.above5Percent);
}

void printRows(const DistanceCase& c, const gpr::MeshView& mesh)
{
	const Ground ground(mesh, c.percent);
	for (Metric metric : {Metric::Default, Metric::BorderEdge}) {
		for (double reach : {1.0, 2.0}) {
			std::printf("| %s | %s | %g r | ", c.words.c_str(),
						metric == Metric::Default ? "default" : "border edges", reach);
			printFigures(measureAccuracy(ground, metric, reach, sourceNum, seed));
		}
	}
}

void printRowsUnderStretch()
{
	constexpr double heightOfTwo = 0.5;
	std::printf(afterTable, sourceNum);
	for (int cellNum : {20, 40, 80, 160}) {
		for (double radius : {0.1, 0.2, 0.4}) {
			std::printf("| %d × %d | %g | %.1f | ", cellNum, cellNum, radius,
						radius * heightOfTwo * cellNum);
			printFigures(measureUnderStretch(cellNum, radius, sourceNum, seed));
		}
	}
}

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
	printRowsUnderStretch();
	std::printf("%s", outro);
	return 0;
}
