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

/// Writes the result mesh, and the data that the options ask for, in the frame and numbering of the
/// input. hasKept: some vertices are input vertices and get the exact coordinates of the input.
/// turnsFaces: cleaning reversed faces; sheets at junctions get the old orientation. Returns shape
/// measures of the triangles. Throws Failure if rounding to the frame makes a degenerate face;
/// `audited` then has the number.
QualityFigures exportResult(RunContext& run, const Surface& surface, const ResultMesh& result,
							bool hasKept, bool turnsFaces, AuditFigures& audited,
							RemeshResult& out);

/// Writes the sample of each vertex of the result. A sample on the surface (up to rounding) gets
/// its exact coordinates back.
void nameSamples(const std::vector<Vec3d>& points, const std::vector<char>& isMoved,
				 const ResultMesh& result, RemeshResult& out);

} // namespace gpr

#endif
