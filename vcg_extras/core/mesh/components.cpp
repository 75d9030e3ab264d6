// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "components.h"

namespace gpr {

Components findComponents(const HalfEdgeMesh& mesh, Workers& workers)
{
	return findComponents(mesh, workers, [](int) { return true; });
}

} // namespace gpr
