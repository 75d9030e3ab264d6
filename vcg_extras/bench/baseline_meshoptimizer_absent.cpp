// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces meshoptimizer in a program built without meshoptimizer.
#include "baseline_meshoptimizer.h"

namespace gpr::bench {

app::BaselineResult simplifyByMeshoptimizer(const app::InputMesh&, std::int64_t)
{
	app::BaselineResult result;
	result.failure = "Left out: this program was built without meshoptimizer.";
	return result;
}

} // namespace gpr::bench
