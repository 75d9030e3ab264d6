// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Remeshes a torus to exactly 500 vertices and saves the result.
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

	Remeshing::Params params;
	params.SetTargetVertexNum(500);
	const Remeshing::Result result = Remeshing::Do(m, params, nullptr, vcg::DummyCallBackPos);
	if (!result.IsOk()) {
		std::fprintf(stderr, "%s\n", result.message.c_str());
		return 1;
	}
	std::printf("%d vertices, %d faces\n", m.VN(), m.FN());
	return vcg::tri::io::ExporterOFF<MyMesh>::Save(m, argc > 1 ? argv[1] : "remeshed.off");
}
