// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints vcg_extras/docs/accuracy_of_distances.md, with the models of GPR_MODELS_DIR where it is
// set:
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
	"# How true the distances are\n"
	"\n"
	"The sampling floods the surface from each sample (paper §3, step 3). The distances of a flood "
	"should be geodesic.\n"
	"This page compares them with exact geodesics of the same polyhedron, which CGAL's "
	"Surface_mesh_shortest_path finds.\n"
	"The sources are %d random points of each surface. All vertices within r and within 2 r are "
	"measured, where r is the\n"
	"disk radius for a target of 10 %% of the vertices (2 %% for the coarse torus). Errors are "
	"relative: +1 %% is a hundredth\n"
	"too long. The surfaces are made by the program. igea and fandisk are [public "
	"models](models.md).\n"
	"\n"
	"- **default** is the placement by disk intersection. Where all normals of the disk are within "
	"37° of its middle's, the\n"
	"  distance is the chord, lengthened for the bend. Elsewhere triangles are unfolded. Chords "
	"are "
	"too short on a noisy surface.\n"
	"- **border edges** is the paper's placement. Triangles are unfolded everywhere.\n"
	"\n"
	"| surface | metric | up to | vertices | mean error | longest | shortest | off by more than 5 "
	"%% "
	"|\n"
	"|---|---|---|---:|---:|---:|---:|---:|\n";

const char* const afterTable =
	"\n"
	"The largest errors are in two places. One is the end of a disk, at a vertex within it whose "
	"straight way runs over a\n"
	"vertex outside. The other is behind hollow corners: unfolding sees the source where the front "
	"would have come from,\n"
	"not the corner that the way goes round. At obtuse and right angles the triangle that holds "
	"the straight way may be\n"
	"settled after the vertex that it leads to. So a vertex is visited again where a way turns up "
	"that is shorter by a thousandth.\n"
	"\n"
	"## Under a density\n"
	"\n"
	"With λ above 0 the paper's placement stretches distances, eq. (4). Each edge is longer by the "
	"mean stretch of its ends.\n"
	"When a triangle is unfolded, its three edges are longer by the mean stretch of its corners, "
	"and vertices are visited\n"
	"again as above. The stretch 1 / y over the plane makes the hyperbolic plane of it, whose "
	"distances are known in closed form.\n"
	"Here it is taken on jittered grids over [0, 1] × [0.25, 1], from %d random points each, for "
	"disks that lie inside.\n"
	"Radii are hyperbolic lengths. \"Edges\" is the radius in edges of the grid, at the height "
	"where the stretch is 2.\n"
	"\n"
	"| cells of the grid | radius | edges | vertices | mean error | longest | shortest | off by "
	"more "
	"than 5 %% |\n"
	"|---|---:|---:|---:|---:|---:|---:|---:|\n";

const char* const outro = "\n"
						  "Bands that fail: `tests/geodesics/distance_accuracy_test.cpp`.\n";

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
