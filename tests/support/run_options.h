// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_RUN_OPTIONS_H
#define GPR_TESTS_SUPPORT_RUN_OPTIONS_H

#include <vcg_extras/core/options.h>

namespace gpr::test {

/// The defaults for a number of vertices, on two threads.
inline RemeshOptions countOptions(std::int64_t vertexNum)
{
	RemeshOptions options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = vertexNum;
	options.threads         = 2;
	return options;
}

} // namespace gpr::test

#endif
