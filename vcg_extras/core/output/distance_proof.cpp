// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_proof.h"

namespace gpr {

namespace {

/// Error of input positions by rounding to single precision; the box is about 1. Positions of the
/// result are compared unrounded.
constexpr double roundingOfPositions = 1e-7;

/// Proven bounds of the distances, both ways. diagonal: of the input, working units.
MutualBounds boundsOf(double diagonal, const ComparedSurfaces& both, Workers& workers)
{
	CertificateSettings settings = usualCertificate(diagonal);
	settings.coordinateError     = roundingOfPositions;
	MutualBounds bounds;
	bounds.toInput   = certifiedDistance(both.result, both.input, settings, workers);
	bounds.fromInput = certifiedDistance(both.input, both.result, settings, workers);
	return bounds;
}

} // namespace

ComparedSurfaces::ComparedSurfaces(const Surface& surface, const ResultMesh& made,
								   Workers& workers) :
		input(viewOf(surface.mesh), workers),
		result(viewOf(made.mesh), input, workers)
{
}

DistanceProof proveDistance(RunContext& run, const Surface& surface, double diagonal,
							const ComparedSurfaces& both)
{
	const double        scale = surface.frame.scale;
	const DistanceProof proof{true, boundsOf(diagonal * scale, both, run.workers).times(1 / scale)};
	if (proof.bounds.hausdorff().isBudgetSpent) {
		run.tell("The proven bounds of the largest distance differ by more than 1 %: the budget of "
				 "the proof was spent.");
	}
	return proof;
}

} // namespace gpr
