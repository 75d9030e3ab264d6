// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification.h"

#include "audit.h"
#include "distance_proof.h"
#include "thorough_check.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/smooth_border.h>
#include <vcg_extras/core/mesh/measure.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace gpr {

namespace {

void tellOperations(const ResultMesh& result, RemeshReport& report)
{
	report.leftoverVertexNum = result.leftoverNum;
	report.splitNum          = result.splitNum;
	report.collapseNum       = result.collapseNum;
	report.flipNum           = result.flipNum;
}

/// Without the exact count eq. (1) is left to itself: tells how near it came, and the constant
/// that would have hit the target, as the count goes with 1/c².
void tellCountReached(RunContext& run, const Expected& expected, const ResultMesh& result)
{
	// Vertices that are kept do not go with the radius.
	if (!isPaper(run.options) || expected.vertexNum == 0 || expected.keptNum > 0) return;
	const double share                 = double(result.mesh.vertexNum) / double(expected.vertexNum);
	run.report.radiusConstantForTarget = run.report.radiusConstant * std::sqrt(share);
	char sentence[160];
	std::snprintf(sentence, sizeof sentence,
				  "%lld vertices of %lld wanted (%+.1f %%); with %.3f instead of %.3f in eq. (1) "
				  "it would have been about as many as wanted.",
				  static_cast<long long>(result.mesh.vertexNum),
				  static_cast<long long>(expected.vertexNum), 100 * (share - 1),
				  run.report.radiusConstantForTarget, run.report.radiusConstant);
	run.notes.push_back(sentence);
}

void tellKept(RunContext& run, const Expected& expected, const ResultMesh& result)
{
	const auto         isPinned = [](const ResultVertex& v) { return v.isPinned; };
	const std::int64_t kept  = std::count_if(result.vertex.begin(), result.vertex.end(), isPinned);
	const std::int64_t lost  = expected.keptNum - kept;
	run.report.keptVertexNum = kept;
	if (2 * kept > result.mesh.vertexNum) {
		run.notes.push_back("More than half of the vertices had to stay where they were; the "
							"triangles beside them are uneven.");
	}
	if (lost > 0) {
		run.notes.push_back(std::to_string(lost) + " of the " + std::to_string(expected.keptNum) +
							" vertices that were to stay could not be kept.");
	}
}

void requirePromises(RunContext& run, const Surface& surface, const ResultMesh& result,
					 std::int64_t promisedNum)
{
	RemeshReport&        report  = run.report;
	const GuardedFigures guarded = report.audit.guarded;
	report.audit =
		audit(surface, result, report.cleanedInput, report.result, promisedNum, run.workers);
	report.audit.guarded = guarded;
	if (!report.audit.passed) throw Failure(Status::PromiseBroken, describeFailure(report.audit));
	if (report.audit.invertedFaces == 0) return;
	run.notes.push_back(std::to_string(report.audit.invertedFaces) +
						" faces are inverted: their normals point against the input's, where the "
						"surface is thinner than the triangles are wide.");
}

/// How far vertices may lie beside the surface, in working units.
double besideBorder(const ResultMesh& result)
{
	return result.hasSmoothBorder ? double(borderSlack * result.idealEdge) : 0;
}

/// The proof may have found points farther than the samples.
void raiseToProven(const MutualBounds& proven, CheckFigures& figures)
{
	MutualDistance& d       = figures.distance;
	d.toInput.max           = std::max(d.toInput.max, proven.toInput.lower);
	d.fromInput.max         = std::max(d.fromInput.max, proven.fromInput.lower);
	figures.largestDistance = d.larger().max;
}

void checkWhereAsked(RunContext& run, const Surface& surface, const ResultMesh& result)
{
	if (!run.options.check) return;
	run.clock.enter(Stage::Check);
	const ComparedSurfaces both(surface, result, run.workers);
	const double           unit    = 1 / surface.frame.scale;
	CheckFigures           figures = checkThoroughly(surface, result, both, run.workers);
	const double           allowed = run.report.largestFitDistance / unit + besideBorder(result);
	const std::string      failure = describeFailure(figures, allowed);
	figures.vertexDistance *= unit;
	figures.distance = figures.distance.times(unit);
	if (!run.report.isDistanceProven) proveDistance(run, surface, both);
	raiseToProven(run.report.provenDistance, figures);
	run.report.check = figures;
	if (!failure.empty()) throw Failure(Status::PromiseBroken, failure);
}

} // namespace

void verifyResult(RunContext& run, const Surface& surface, const ResultMesh& result,
				  const Expected& expected)
{
	run.clock.enter(Stage::Audit);
	run.report.result = figuresOf(result.mesh, 1 / surface.frame.scale, run.workers);
	tellOperations(result, run.report);
	tellCountReached(run, expected, result);
	tellKept(run, expected, result);
	requirePromises(run, surface, result, isPaper(run.options) ? 0 : expected.vertexNum);
	checkWhereAsked(run, surface, result);
}

} // namespace gpr
