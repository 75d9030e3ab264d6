// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_DISTANCE_PROOF_H
#define VCG_EXTRAS_CORE_OUTPUT_DISTANCE_PROOF_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/certified_distance.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// The input and the result, ready for proofs about their distance; working units.
struct ComparedSurfaces {
	MeasuredSurface input, result;

	ComparedSurfaces(const Surface& surface, const ResultMesh& made, Workers& workers);
};

/// Bounds of the distances of both from each other, proven; working units. Cost: see
/// certifiedDistance.
MutualBounds boundsOf(const RunContext& run, const Surface& surface, const ComparedSurfaces& both);

/// Proves these bounds and tells them in the report.
void proveDistance(RunContext& run, const Surface& surface, const ComparedSurfaces& both);

} // namespace gpr

#endif
