// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_STAGES_OF_H
#define GPR_TESTS_SUPPORT_STAGES_OF_H

#include <vcg_extras/core/base/stages.h>

#include <vector>

namespace gpr::test {

/// The stages of a pipeline in their order.
inline std::vector<Stage> stagesOf(Pipeline pipeline)
{
	std::vector<Stage> stages;
	for (const StageRow& row : stageTable) {
		if (shareAtEnd(row.stage, pipeline) > 0) stages.push_back(row.stage);
	}
	return stages;
}

} // namespace gpr::test

#endif
