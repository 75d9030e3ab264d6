// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "thorough_check.h"

#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/surface/surface_distance.h>

namespace gpr {

ComparedSurfaces::ComparedSurfaces(const Surface& surface, const ResultMesh& made,
								   Workers& workers) :
		input(viewOf(surface.mesh), workers),
		result(viewOf(made.mesh), input, workers)
{
}

DistanceProof proveDistance(RunContext& run, const Surface& surface, double diagonal,
							const ComparedSurfaces& both, double wanted)
{
	// Error of input positions by rounding to single precision; the box is about 1. Positions of
	// the result are compared unrounded.
	constexpr double    rounding = 1e-7;
	const double        scale    = surface.frame.scale;
	CertificateSettings settings = usualCertificate(diagonal * scale);
	settings.coordinateError     = rounding;
	settings.wanted              = wanted * scale;
	const MutualBounds  bounds = certifiedDistances(both.input, both.result, settings, run.workers);
	const DistanceProof proof{true, bounds.times(1 / scale)};
	if (proof.bounds.hausdorff().isBudgetSpent) {
		run.tell("The proven bounds of the largest distance differ by more than 1 %: the budget of "
				 "the proof was spent.");
	}
	return proof;
}

CheckFigures checkThoroughly(const Surface& surface, const ResultMesh& made,
							 const ComparedSurfaces& both, Workers& workers)
{
	const HalfEdgeMesh &input = surface.mesh, &result = made.mesh;
	CheckFigures        figures;
	figures.done              = true;
	figures.intersectingFaces = std::int64_t(findTouchingFaces(result, workers).size());
	if (figures.intersectingFaces > 0) {
		// The sides of a cut touch, as for the guard (InputContacts).
		figures.inputIntersectingFaces =
			std::int64_t(findTouchingFaces(input, workers, Seams::Apart).size());
	}
	constexpr int         pointsPerFace = 10; // at the most points, 200 are beyond the p99.9
	const SampledDistance distance =
		sampledDistance({input, both.input}, {result, both.result}, pointsPerFace, workers);
	figures.vertexDistance  = distance.vertexDistance;
	figures.distance        = distance.mutual;
	figures.largestDistance = figures.distance.larger().max;
	return figures;
}

std::string describeFailure(const CheckFigures& figures, double fitDistance)
{
	// Rounding of positions, the box being about 1, and of nearest points.
	constexpr double rounding = 1e-5;
	std::string      what;
	const auto       add = [&](bool failed, const std::string& phrase) {
        if (failed) what += (what.empty() ? "" : ", ") + phrase;
	};
	add(figures.intersectingFaces > 0 && figures.inputIntersectingFaces == 0,
		std::to_string(figures.intersectingFaces) + " self-intersecting faces");
	add(!(figures.vertexDistance <= fitDistance + rounding),
		"vertices farther from the input than the largest move of the fit");
	if (what.empty()) return "";
	return "The result was withheld because it has " + what + ".";
}

} // namespace gpr
