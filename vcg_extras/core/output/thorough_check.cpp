// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "thorough_check.h"

#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/surface/surface_distance.h>

namespace gpr {

CheckFigures checkThoroughly(const Surface& surface, const ResultMesh& made,
							 const ComparedSurfaces& both, Workers& workers)
{
	const HalfEdgeMesh &input = surface.mesh, &result = made.mesh;
	CheckFigures        figures;
	figures.done              = true;
	figures.intersectingFaces = std::int64_t(facesOf(findTouchingPairs(result, workers)).size());
	if (figures.intersectingFaces > 0) {
		// The sides of a cut touch, as for the guard (InputContacts).
		figures.inputIntersectingFaces =
			std::int64_t(facesOf(findTouchingPairs(input, workers, Seams::Apart)).size());
	}
	const SampledDistance distance =
		sampledDistance({input, both.input}, {result, both.result}, workers);
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
