// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_DISTANCE_PROOF_H
#define VCG_EXTRAS_CORE_OUTPUT_DISTANCE_PROOF_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/certified_distance.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Input and result, ready for proofs about their distance; working units.
struct ComparedSurfaces {
	MeasuredSurface input, result;

	ComparedSurfaces(const Surface& surface, const ResultMesh& made, Workers& workers);
};

/// Bounds of the largest distance between input and result.
struct DistanceProof {
	bool         isMade = false;
	MutualBounds bounds; ///< mesh units
};

/// Proves bounds of the distances between input and result, and writes a note if the budget of the
/// proof was spent. diagonal: of the input, mesh units. Cost: see certifiedDistance.
DistanceProof proveDistance(RunContext& run, const Surface& surface, double diagonal,
							const ComparedSurfaces& both);

} // namespace gpr

#endif
