// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Quadric Edge Collapse as in MeshLab, timed.
#include "baseline_remeshers.h"

#include <vcg_extras/complex/baselines/quadric_collapse.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/base/stopwatch.h>

namespace gpr::app {

BaselineResult collapseQuadricEdges(const MeshView& mesh, std::int64_t faceNum,
									const StopQuestion& shallStop)
{
	BaselineResult             result;
	baselines::QuadricCollapse collapse(mesh);
	const Stopwatch            clock;
	const double               processorBefore = processorSeconds();
	if (!collapse.run(faceNum, shallStop)) {
		result.failure = "Quadric Edge Collapse was stopped.";
		return result;
	}
	result.seconds          = clock.seconds();
	result.processorSeconds = processorSeconds() - processorBefore;
	result.mesh             = collapse.mesh();
	if (result.mesh.faceNum() == 0) result.failure = "Quadric Edge Collapse left no face.";
	return result;
}

} // namespace gpr::app
