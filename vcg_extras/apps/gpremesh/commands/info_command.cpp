// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"

#include <vcg_extras/apps/gpremesh/report/summary.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/io/mesh_io.h>

namespace gpr::app {

void runInfo(const CommandLine& line)
{
	WantedAttributes wanted;
	wanted.carried       = true;
	wanted.mayStayInFile = true;
	const InputMesh mesh = readMesh(line.input, wanted);
	MeshInfo        info;
	info.path            = line.input;
	info.doublePrecision = mesh.doublePrecision;
	info.figures         = measureMesh(mesh.view());
	info.quality         = measureQuality(mesh.view());
	info.parts           = measureParts(mesh);
	info.notes           = mesh.notes;
	print(line.json ? meshInfoJson(info) : meshInfoText(info));
}

} // namespace gpr::app
