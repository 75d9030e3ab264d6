// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces CGAL in a program built without CGAL.
#include "baseline_cgal.h"

namespace gpr::bench {

app::BaselineResult remeshByCgal(const app::InputMesh&, std::int64_t)
{
	app::BaselineResult result;
	result.failure = "Left out: this program was built without CGAL.";
	return result;
}

} // namespace gpr::bench
