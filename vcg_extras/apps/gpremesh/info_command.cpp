// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "info_command.h"

#include "mesh_io.h"
#include "summary.h"

#include <cstdio>
#if __has_include(<vcg_extras/core/measure.h>)
#include <vcg_extras/core/measure.h>
#else
namespace gpr {
// Until the engine measures: the counts alone.
static MeshFigures measureMesh(const MeshView& mesh)
{
	MeshFigures figures;
	figures.vertices = std::int64_t(mesh.vertexNum);
	figures.faces    = std::int64_t(mesh.faceNum);
	return figures;
}
static QualityFigures measureQuality(const MeshView&)
{
	return {};
}
} // namespace gpr
#endif

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
