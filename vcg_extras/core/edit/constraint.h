// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_CONSTRAINT_H
#define VCG_EXTRAS_CORE_EDIT_CONSTRAINT_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// The freedom of a vertex of the result.
enum class Constraint {
	Fixed,   ///< stays: corners of curves, cone apexes, pinned vertices of curves
	Curve,   ///< slides along its border or feature line, as far as slideRoom allows
	Surface, ///< walks over the surface and stays on it: samples of a line lost by the mesh
	Free,    ///< walks over the surface; the fit may take the vertex off the surface
};

/// Whether the vertex walks over the surface.
inline bool mayWalk(Constraint c)
{
	return c == Constraint::Surface || c == Constraint::Free;
}

Constraint constraintOf(const ResultMesh& result, int v);

} // namespace gpr

#endif
