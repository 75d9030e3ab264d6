// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_cases.h"

#include <tests/support/mesh_builders.h>

#include <cmath>

namespace gpr::test {

namespace {

TriangleMesh bumpySphere(int level)
{
	TriangleMesh mesh = icosphere(level);
	for (Vec3d& p : mesh.positions)
		p = p * (1 + 0.2 * std::sin(5 * p.x) * std::sin(4 * p.y + 1) * std::cos(3 * p.z));
	return mesh;
}

} // namespace

std::vector<DistanceCase> madeDistanceCases()
{
	Random random(1);
	return {
		{"plane", "plane, jittered grid", jitteredGrid(60, 0.3, random), 10, 0.002, 0.12},
		{"sphere", "sphere", icosphere(5)},
		{"torus", "torus", torus(120, 60)},
		{"coarseTorus", "torus, disks a quarter round the tube", torus(60, 30), 2, 0.01, 0.08},
		{"bumpySphere", "bumpy sphere", bumpySphere(5)},
		{"needles", "sphere of latitudes and longitudes: needles at the poles", uvSphere(60, 120)},
		{"noisySphere", "sphere with noise", noisySphere(5, 0.004, random)},
		{"box", "cube: creases and corners", cube(24)},
		{"lPrism", "prism over an L: a hollow crease", lPrism(16), 10, 0.004, 0.09},
		{"thinPlate", "plate thinner than the disks", thinPlate(40, 0.02)}};
}

std::vector<DistanceCase> modelDistanceCases()
{
	return {{"igea_269k", "igea_269k, a scan", {}, 10, 0.004, 0.09},
			{"fandisk_13k_cad", "fandisk_13k, a machine part", {}}};
}

} // namespace gpr::test
