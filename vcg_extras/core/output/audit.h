// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_AUDIT_H
#define VCG_EXTRAS_CORE_OUTPUT_AUDIT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Checks a result before its export:
/// - every edge has one or two faces, in opposite directions; every vertex has a single fan;
/// - no two faces have the same corners; no face is degenerate; all coordinates are finite;
/// - components, border loops and Euler characteristic are as in `input`;
/// - the vertex count is targetNum (0: any count).
/// At junctions all checks but the count apply to the sheets, and the junctions must be the same.
/// Inverted faces (isInverted in face_point.h) are counted but allowed: on a surface thinner than
/// the triangles are wide, no mesh with this count has all normals right. Cost: linear, parallel;
/// O(F log F) more after a fault.
AuditFigures audit(const Surface& surface, const ResultMesh& result, const MeshFigures& input,
				   const MeshFigures& output, std::int64_t targetNum, Workers& workers);

/// A sentence with the failed checks; empty if the audit passed.
std::string describeFailure(const AuditFigures& figures);

} // namespace gpr

#endif
