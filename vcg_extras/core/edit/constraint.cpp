// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "constraint.h"

namespace gpr {

Constraint constraintOf(const ResultMesh& result, int v)
{
	const ResultVertex& record = result.vertex[v];
	if (record.isCorner) return Constraint::Fixed;
	const bool isFree = record.curve < 0 && !record.isPinned;
	if (!result.mesh.isCurveVertex(v)) return isFree ? Constraint::Free : Constraint::Surface;
	return record.curve >= 0 && !record.isPinned ? Constraint::Curve : Constraint::Fixed;
}

} // namespace gpr
