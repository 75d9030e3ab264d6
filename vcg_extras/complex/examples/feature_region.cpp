// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Remeshes a torus to exactly 1000 vertices, with smaller triangles on its selected half.
#include "example_mesh.h"

#include <vcg_extras/complex/algorithms/geodesic_poisson_remeshing.h>

#include <cstdio>
#include <vcg/complex/algorithms/create/platonic.h>
#include <wrap/io_trimesh/export_off.h>

int main(int argc, char** argv)
{
	typedef vcg::tri::GeodesicPoissonRemeshing<MyMesh> Remeshing;

	MyMesh m;
	vcg::tri::Torus(m, 2, 1, 96, 48);
	for (MyVertex& v : m.vert)
		if (v.P()[0] > 0) v.SetS();

	Remeshing::Params params;
	Remeshing::Stat   stat;
	params.SetTargetVertexNum(1000);
	params.featureRegion    = gpr::FeatureRegion::Selection; // or Detected: creases and cone apexes
	params.featureDiskScale = 0.5;
	const Remeshing::Result result = Remeshing::Do(m, params, &stat);
	if (!result.IsOk()) {
		std::fprintf(stderr, "%s\n", result.message.c_str());
		return 1;
	}
	std::printf("%d vertices were selected\n", int(stat.regionVertexNum));
	std::printf("%d vertices, %d faces\n", m.VN(), m.FN());
	return vcg::tri::io::ExporterOFF<MyMesh>::Save(m, argc > 1 ? argv[1] : "feature_region.off");
}
