// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_EXPORT_H
#define VCG_EXTRAS_CORE_OUTPUT_EXPORT_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/results.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// Last stage: writes the mesh, and what the options ask for beside it, in the caller's frame and
/// numbering. hasKept: vertices of the caller's stayed, and get the caller's own bits back.
/// turnsFaces: cleaning turned faces over, and where sheets meet their orientation comes back.
/// Returns the shape of the triangles. Throws Failure where rounding to that frame leaves a face
/// without area; `audited` then tells how many.
QualityFigures exportResult(RunContext& run, const Surface& surface, const ResultMesh& result,
							bool hasKept, bool turnsFaces, AuditFigures& audited,
							RemeshResult& out);

/// Tells which vertex of the result is which of the caller's samples. A sample that lay on the
/// surface, up to rounding, keeps its very coordinates.
void nameSamples(const std::vector<Vec3d>& points, const std::vector<char>& isMoved,
				 const ResultMesh& result, RemeshResult& out);

} // namespace gpr

#endif
