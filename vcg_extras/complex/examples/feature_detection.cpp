// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the creases of a dodecahedron and saves the faces at creases.
#include "example_mesh.h"

#include <vcg_extras/complex/algorithms/feature_detection.h>

#include <cstdio>
#include <vcg/complex/algorithms/create/platonic.h>
#include <wrap/io_trimesh/export_off.h>

int main(int argc, char** argv)
{
	typedef vcg::tri::FeatureDetection<MyMesh> Detection;

	MyMesh m;
	vcg::tri::Dodecahedron(m);

	Detection::Features features;
	Detection::Params   params;
	Detection::Stat     stat;
	params.strongAngleDeg          = 60;
	const Detection::Result result = Detection::Detect(m, features, params, &stat);
	if (!result.IsOk()) {
		std::fprintf(stderr, "%s\n", result.message.c_str());
		return 1;
	}
	std::printf("%d edges, %d corners\n", int(stat.edgeNum), int(stat.cornerNum));
	for (std::size_t f = 0; f < m.face.size(); ++f)
		if (!features.faceMark[f]) vcg::tri::Allocator<MyMesh>::DeleteFace(m, m.face[f]);
	return vcg::tri::io::ExporterOFF<MyMesh>::Save(m, argc > 1 ? argv[1] : "features.off");
}
