// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for meshoptimizer where the program is built without it.
#include "baseline_meshoptimizer.h"

namespace gpr::bench {

app::BaselineResult simplifyByMeshoptimizer(const app::InputMesh&, std::int64_t)
{
	app::BaselineResult result;
	result.failure = "Left out: this program was built without meshoptimizer.";
	return result;
}

} // namespace gpr::bench
