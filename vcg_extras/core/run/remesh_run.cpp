// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_run.h"

#include "border_smoothing.h"
#include "error_guide.h"
#include "feature_lines.h"
#include "guarded_result.h"
#include "kept_input.h"
#include "meshing.h"
#include "preparation.h"
#include "target.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/output/distance_proof.h>
#include <vcg_extras/core/output/export.h>
#include <vcg_extras/core/output/verification.h>

#include <cstdint>
#include <string>
#include <utility>

namespace gpr {

namespace {

/// Prepared for the count that the options ask for, or for a greater one that vertices to be kept
/// need.
Prepared prepareWithRoom(RunContext& run, const FeatureMarks& marks)
{
	Prepared     p      = prepare(run, marks);
	const Target target = targetWithRoom(run.options, p.targetNum, std::int64_t(p.kept.size()));
	if (target.vertexNum == p.targetNum) return p;
	run.notes.push_back(target.note);
	return prepareFor(run, marks, target.vertexNum);
}

void tellLinesNotFollowed(RunContext& run)
{
	const FeatureMode mode = run.options.featureMode;
	if (!isPaper(run.options) || mode == FeatureMode::Off || mode == FeatureMode::Auto) return;
	run.notes.push_back("Feature lines are not followed with the preset paper.");
}

void measureError(RunContext& run, const Surface& surface, const ResultMesh& result)
{
	run.clock.enter(Stage::Error);
	const ComparedSurfaces both(surface, result, run.workers);
	proveDistance(run, surface, both);
	if (run.guide == nullptr || run.report.provenDistance.hausdorff().upper <= run.guide->goal)
		return;
	findPlacesBeyond(run, surface, both, result.idealEdge);
}

/// Smaller triangles may touch others, and what is made anew there may be too far from the input.
void keepToGoal(RunContext& run, MeshedSurface& made, KnownContacts& contacts, ResultMesh& result)
{
	constexpr int mostTimes = 3;
	for (int time = 0; time < mostTimes; ++time) {
		const int added = refineToGoal(run, made.prepared.surface, made.meshed.curves, result);
		if (added == 0) return;
		run.guide->addedNum += added;
		made.prepared.targetNum += added;
		run.report.targetVertexNum = made.prepared.targetNum;
		removeContacts(run, made.prepared, contacts, result);
	}
}

void remeshOnce(RunContext& run, LargestDistance largest, RemeshResult& out)
{
	const FeatureMarks marks    = regionOfRun(run);
	Prepared           prepared = prepareWithRoom(run, marks);
	findFeatureLines(run, prepared);
	tellLinesNotFollowed(run);

	MeshedSurface  made     = meshForTarget(run, marks, std::move(prepared));
	const Surface& surface  = made.prepared.surface;
	ResultMesh&    result   = made.meshed.result;
	KnownContacts  contacts = fitResult(run, made.prepared, made.meshed.curves, largest, result);
	removeContacts(run, made.prepared, contacts, result);
	if (run.guide != nullptr) keepToGoal(run, made, contacts, result);
	if (largest == LargestDistance::Counts) measureError(run, surface, result);
	tellSmoothBorder(run, surface, result);
	const Expected expected{made.prepared.targetNum, std::int64_t(made.prepared.kept.size())};
	verifyResult(run, surface, result, expected);
	exportResult(run, surface, result, out);
}

/// Named counts up to this one are tried out.
constexpr std::int64_t maxTriedVertices = 64;

/// The count that a run for so many vertices is refused with, or 0 where it is not.
std::int64_t smallestInstead(RunContext& run, LargestDistance largest, std::int64_t vertexNum)
{
	RemeshOptions options   = run.options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = vertexNum;
	RemeshResult trial;
	RunContext   context{
        run.input,   options,
        run.workers, trial.report,
        trial.notes, StageClock(run.workers, trial.report, Pipeline::Remeshing, {1, 1})};
	context.kept = run.kept;
	try {
		remeshOnce(context, largest, trial);
	}
	catch (const Failure& failure) {
		return failure.status == Status::CountTooSmall ? failure.smallestVertexNum : 0;
	}
	return 0;
}

/// What topology allows may still not be free of self-intersections: the count named shall be one
/// that can be had.
Failure withCountToBeHad(RunContext& run, LargestDistance largest, const Failure& failure)
{
	std::int64_t smallest = failure.smallestVertexNum;
	while (smallest > 0 && smallest <= maxTriedVertices) {
		const std::int64_t instead = smallestInstead(run, largest, smallest);
		if (instead <= smallest) break;
		smallest = instead;
	}
	if (smallest == failure.smallestVertexNum) return failure;
	return {failure.status,
			"The surface cannot be meshed with " + std::to_string(run.report.targetVertexNum) +
				" vertices; the smallest possible number without self-intersections that was found "
				"is " +
				std::to_string(smallest) + ".",
			smallest};
}

} // namespace

void remeshInput(RunContext& run, LargestDistance largest, RemeshResult& out)
{
	try {
		remeshOnce(run, largest, out);
	}
	catch (const Failure& failure) {
		if (failure.status != Status::CountTooSmall || !run.options.guard) throw;
		throw withCountToBeHad(run, largest, failure);
	}
}

} // namespace gpr
