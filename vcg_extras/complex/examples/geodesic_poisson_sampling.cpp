// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Spreads about 500 points evenly over a torus and saves the points as a point cloud.
#include "example_mesh.h"

#include <vcg_extras/complex/algorithms/geodesic_poisson_sampling.h>

#include <cstdio>
#include <vcg/complex/algorithms/create/platonic.h>
#include <wrap/io_trimesh/export_off.h>

int main(int argc, char** argv)
{
	typedef vcg::tri::GeodesicPoissonSampling<MyMesh> Sampling;

	MyMesh m, points;
	vcg::tri::Torus(m, 2, 1, 96, 48);

	Sampling::Params params;
	Sampling::Stat   stat;
	params.SetTargetVertexNum(500);
	const Sampling::Result result = Sampling::Sample(m, params, points, &stat);
	if (!result.IsOk()) {
		std::fprintf(stderr, "%s\n", result.message.c_str());
		return 1;
	}
	std::printf("%d points, disk radius %g\n", points.VN(), stat.diskRadius);
	return vcg::tri::io::ExporterOFF<MyMesh>::Save(points, argc > 1 ? argv[1] : "samples.off");
}
