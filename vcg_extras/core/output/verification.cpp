// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification.h"

#include "audit.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/smooth_border.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/sampling/target.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace gpr {

namespace {

/// Without the exact count, reports how near the count by eq. (1) came to the target. Returns the
/// constant that would have met the target, as the count is proportional to 1/c².
double tellCountReached(RunContext& run, const Expected& expected, const ResultMesh& result)
{
	if (!isPaper(run.options) || expected.vertexNum == 0) return 0;
	const double share    = double(result.mesh.vertexNum) / double(expected.vertexNum);
	const double constant = radiusConstant(run.options);
	const double better   = constant * std::sqrt(share);
	const bool   isHelp   = expected.keptNum == 0; // kept vertices do not depend on the radius
	char         found[100], advice[100];
	std::snprintf(found, sizeof found, "The result has %lld of %lld wanted vertices (%+.1f %%).",
				  static_cast<long long>(result.mesh.vertexNum),
				  static_cast<long long>(expected.vertexNum), 100 * (share - 1));
	std::snprintf(advice, sizeof advice,
				  " The constant %.3f in eq. (1), instead of %.3f, would give about the wanted "
				  "number.",
				  better, constant);
	run.tell(found + std::string(isHelp ? advice : ""));
	return isHelp ? better : 0;
}

std::int64_t tellKept(RunContext& run, const Expected& expected, const ResultMesh& result)
{
	const auto         isPinned = [](const ResultVertex& v) { return v.isPinned; };
	const std::int64_t kept = std::count_if(result.vertex.begin(), result.vertex.end(), isPinned);
	const std::int64_t lost = expected.keptNum - kept;
	if (2 * kept > result.mesh.vertexNum) {
		run.tell("More than half of the vertices had to keep their places; the triangles beside "
				 "these vertices are irregular.");
	}
	if (lost > 0) {
		run.tell(std::to_string(lost) + " of the " + std::to_string(expected.keptNum) +
				 " vertices to be kept were lost.");
	}
	return kept;
}

void requirePromises(RunContext& run, const Surface& surface, const ResultMesh& result,
					 const Expected& expected, Verification& found)
{
	const std::int64_t promisedNum = isPaper(run.options) ? 0 : expected.vertexNum;
	found.audit = audit(surface, result, expected.input, found.figures, promisedNum, run.workers);
	if (!found.audit.passed) throw Failure(Status::PromiseBroken, describeFailure(found.audit));
	if (found.audit.invertedFaces == 0) return;
	run.tell(std::to_string(found.audit.invertedFaces) +
			 " faces are inverted: their normals point against the normals of the input. The "
			 "surface is thin there, and the triangles are wide.");
}

/// Largest distance of vertices beside the surface, in working units.
double besideBorder(const ResultMesh& result)
{
	return result.hasSmoothBorder ? double(borderSlack * result.idealEdge) : 0;
}

/// Raises the largest sampled distances to the proven lower bounds.
void raiseToProven(const MutualBounds& proven, CheckFigures& figures)
{
	MutualDistance& d       = figures.distance;
	d.toInput.max           = std::max(d.toInput.max, proven.toInput.lower);
	d.fromInput.max         = std::max(d.fromInput.max, proven.fromInput.lower);
	figures.largestDistance = d.larger().max;
}

void checkWhereAsked(RunContext& run, const Surface& surface, const ResultMesh& result,
					 const Expected& expected, Verification& found)
{
	if (!run.options.check) return;
	run.clock.enter(Stage::Check);
	const ComparedSurfaces both(surface, result, run.workers);
	const double           unit    = 1 / surface.frame.scale;
	CheckFigures           figures = checkThoroughly(surface, result, both, run.workers);
	const double           allowed = double(found.fitDistance) + besideBorder(result);
	const std::string      failure = describeFailure(figures, allowed);
	figures.vertexDistance *= unit;
	figures.distance = figures.distance.times(unit);
	if (!found.proof.isMade)
		found.proof = proveDistance(run, surface, expected.input.diagonal, both);
	raiseToProven(found.proof.bounds, figures);
	found.check = figures;
	if (!failure.empty()) throw Failure(Status::PromiseBroken, failure);
}

} // namespace

void tellSmoothBorder(RunContext& run, const Frame& frame, const ResultMesh& result,
					  BorderFigures& border)
{
	constexpr double leastShare = 5e-4; // a smaller change needs no note
	if (!border.isSmooth()) return;
	border.resultLength  = borderLength(result.mesh) / frame.scale;
	const double shorter = 1 - border.resultLength / border.length;
	if (shorter < leastShare) return;
	char sentence[80];
	std::snprintf(sentence, sizeof sentence,
				  "The border is %.2g %% shorter than the border of the input.", 100 * shorter);
	run.tell(sentence);
}

void verifyResult(RunContext& run, const Surface& surface, const ResultMesh& result,
				  const Expected& expected, Verification& found)
{
	run.clock.enter(Stage::Audit);
	found.figures           = figuresOf(result.mesh, 1 / surface.frame.scale, run.workers);
	found.constantForTarget = tellCountReached(run, expected, result);
	found.keptNum           = tellKept(run, expected, result);
	found.fitDistance       = farthestFromSurface(result);
	requirePromises(run, surface, result, expected, found);
	checkWhereAsked(run, surface, result, expected, found);
	found.figures.vertices = result.vertexNum();
}

} // namespace gpr
