// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_THOROUGH_CHECK_H
#define VCG_EXTRAS_CORE_OUTPUT_THOROUGH_CHECK_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/surface/certified_distance.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <string>

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
/// proof was spent. diagonal: of the input, mesh units. wanted: a bound to prove, mesh units; 0:
/// none. Cost: see certifiedDistance.
DistanceProof proveDistance(RunContext& run, const Surface& surface, double diagonal,
							const ComparedSurfaces& both, double wanted = 0);

/// Checks too costly for the audit: searches self-intersections, and measures distances by nearest
/// points, without trust in the surface points of the run. Searches self-intersections of the input
/// only if the result has some. Figures are in working units. both: made from `surface` and
/// `result`. Cost: O(F log F) of both meshes, parallel.
CheckFigures checkThoroughly(const Surface& surface, const ResultMesh& result,
							 const ComparedSurfaces& both, Workers& workers);

/// A sentence with the broken promises, empty if none. Promised are no self-intersecting faces if
/// the input has none, and no vertex farther from the input than fitDistance, the largest move of
/// the fit in working units.
std::string describeFailure(const CheckFigures& figures, double fitDistance);

} // namespace gpr

#endif
