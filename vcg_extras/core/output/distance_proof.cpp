// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_proof.h"

namespace gpr {

namespace {

/// What rounding to single precision does to positions of the input, whose box is about 1. Those of
/// the result are handed over as they are.
constexpr double roundingOfPositions = 1e-7;

} // namespace

ComparedSurfaces::ComparedSurfaces(const Surface& surface, const ResultMesh& made,
								   Workers& workers) :
		input(viewOf(surface.mesh), workers),
		result(viewOf(made.mesh), input, workers)
{
}

MutualBounds boundsOf(const RunContext& run, const Surface& surface, const ComparedSurfaces& both)
{
	CertificateSettings settings =
		usualCertificate(run.report.input.diagonal * surface.frame.scale);
	settings.coordinateError = roundingOfPositions;
	MutualBounds bounds;
	bounds.toInput   = certifiedDistance(both.result, both.input, settings, run.workers);
	bounds.fromInput = certifiedDistance(both.input, both.result, settings, run.workers);
	return bounds;
}

void proveDistance(RunContext& run, const Surface& surface, const ComparedSurfaces& both)
{
	RemeshReport& report    = run.report;
	report.provenDistance   = boundsOf(run, surface, both).times(1 / surface.frame.scale);
	report.isDistanceProven = true;
	if (report.provenDistance.hausdorff().isBudgetSpent) {
		run.notes.push_back("The bounds of the largest distance are proven, but they are farther "
							"from each other than 1 %: their budget was spent.");
	}
}

} // namespace gpr
