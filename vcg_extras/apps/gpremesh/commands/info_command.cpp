// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "info_command.h"

#include <vcg_extras/apps/gpremesh/report/summary.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/io/mesh_io.h>

#include <cstdio>

namespace gpr::app {

void runInfo(const CommandLine& line)
{
	const InputMesh      mesh    = readMesh(line.input);
	const MeshFigures    figures = measureMesh(mesh.view());
	const QualityFigures quality = measureQuality(mesh.view());
	const auto           tell    = line.json ? meshInfoJson : meshInfoText;
	std::fputs(tell(line.input, mesh.doublePrecision, figures, quality, mesh.notes).c_str(),
			   stdout);
}

} // namespace gpr::app
