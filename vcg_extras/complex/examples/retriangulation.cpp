// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Takes every tenth vertex of a torus as a sample and saves the mesh with these vertices.
#include "example_mesh.h"

#include <vcg_extras/complex/algorithms/retriangulation.h>

#include <cstdio>
#include <vcg/complex/algorithms/create/platonic.h>
#include <wrap/io_trimesh/export_off.h>

int main(int argc, char** argv)
{
	typedef vcg::tri::Retriangulation<MyMesh> Retriangulation;

	MyMesh m, coarse;
	vcg::tri::Torus(m, 2, 1, 96, 48);

	std::vector<MyMesh::CoordType> samples;
	for (int i = 0; i < m.VN(); i += 10)
		samples.push_back(m.vert[i].P());
	const Retriangulation::Result result = Retriangulation::Do(m, samples, coarse);
	if (!result.IsOk()) {
		std::fprintf(stderr, "%s\n", result.message.c_str());
		return 1;
	}
	std::printf("%d vertices, %d faces\n", coarse.VN(), coarse.FN());
	return vcg::tri::io::ExporterOFF<MyMesh>::Save(coarse, argc > 1 ? argv[1] : "coarse.off");
}
