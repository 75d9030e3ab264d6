// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_AUDIT_H
#define VCG_EXTRAS_CORE_OUTPUT_AUDIT_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Last stage: checks what is promised before the result is exported. Every edge has one or two
/// faces that run along it in opposite directions, every vertex one fan, no two faces the same
/// corners; no face without area; no coordinate that is not finite; components, boundary loops and
/// Euler characteristic as in `input`, the count as in targetNum (0: not promised). Where sheets
/// meet all this is said of the sheets but the count, and the junctions are the same. Inverted
/// faces (isInverted in face_point.h) are counted, but do not fail the audit: where a surface is
/// thinner than the triangles are wide, no set of that many triangles looks right everywhere. Cost:
/// linear, parallel; O(F log F) more where a fault was found.
AuditFigures audit(const Surface& surface, const ResultMesh& result, const MeshFigures& input,
				   const MeshFigures& output, std::int64_t targetNum, Workers& workers);

/// Faces that have no area in the caller's frame, where rounding is another. Cost: a parallel pass.
std::int64_t zeroAreaFaceNum(const TriangleMesh& mesh, Workers& workers);

/// What failed, as one sentence; empty if the audit passed.
std::string describeFailure(const AuditFigures& figures);

} // namespace gpr

#endif
