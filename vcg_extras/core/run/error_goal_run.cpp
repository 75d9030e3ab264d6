// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_goal_run.h"

#include "error_goal.h"
#include "error_guide.h"
#include "kept_input.h"
#include "preparation.h"
#include "remesh_run.h"
#include "target.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/sampling/error_sizes.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace gpr {

namespace {

/// The same as in the trials: the largest size over the even one, and how fast sizes grow.
constexpr float largestByError = 1.3f, slopeOfSizes = 0.15f;

/// What the trials so far came to.
struct Trials {
	KeptInput&   kept; ///< what they have in common
	RemeshResult best;
	FineSpots    spots; ///< where triangles are to be smaller
	int          num          = 0;
	double       stageSeconds = 0; ///< of all of them
};

/// What is promised: the proven bound.
double errorOf(const RemeshResult& result)
{
	return result.report.provenDistance.hausdorff().upper;
}

RemeshOptions trialOptions(RemeshOptions options, std::int64_t vertexNum)
{
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = vertexNum;
	options.allowNearest    = true;
	return options;
}

ErrorGoal goalOf(const MeshView& input, const RemeshOptions& options, const MeshExtent& extent)
{
	ErrorGoal goal;
	goal.largest = options.targetMaxError * (options.maxErrorIsPercent ? extent.diagonal / 100 : 1);
	goal.most    = std::min<std::int64_t>(200000000, 10000 + 10 * std::int64_t(input.vertexNum));
	const double edge = edgePerError * goal.largest;
	const double n    = edge > 0 ? vertexNumForEdgeLength(extent.area, edge) : 1;
	goal.start        = std::int64_t(std::min(double(goal.most), std::max(4.0, n)));
	return goal;
}

/// How flat the disks of triangles are to be, over the largest error: see sizesByError. The places
/// that are beyond the goal then are few enough to be made finer one by one.
constexpr double flatnessShare = 0.75;

/// The count with which triangles would be as flat as the goal asks for, but for few of them.
std::int64_t forecastCount(RunContext& run, const ErrorGoal& goal, KeptInput& kept)
{
	constexpr int steps   = 3;
	RemeshOptions options = trialOptions(run.options, goal.start);
	RemeshReport  report;
	options.adapt = 0; // sizes are looked for here
	std::vector<std::string> notes;
	RunContext               context{run.input,   options,
                       run.workers, report,
                       notes,       StageClock(run.workers, report, Pipeline::Remeshing, {0, 0})};
	context.kept          = &kept;
	const Prepared p      = prepare(context, regionOfRun(context));
	const double   wanted = flatnessShare * goal.largest * p.surface.frame.scale;
	double         num    = double(p.targetNum);
	for (int i = 0; i < steps; ++i) {
		const float even = evenEdge(p) * float(std::sqrt(double(p.targetNum) / num));
		const float flat =
			sizesByError(p.surface.mesh, {even, largestByError * even, slopeOfSizes}, run.workers)
				.epsilon;
		num *= std::clamp(double(flat) / wanted, 0.1, 10.0);
		num = std::clamp(num, 4.0, double(goal.most));
	}
	return std::int64_t(num);
}

double secondsOf(const std::vector<StageTime>& stages)
{
	double sum = 0;
	for (const StageTime& s : stages)
		sum += s.seconds;
	return sum;
}

/// A whole run of its own, with this share of the work.
RemeshResult remeshWith(RunContext& run, std::int64_t vertexNum, WorkShare share, ErrorGuide& guide,
						KeptInput& kept)
{
	RemeshResult        trial;
	const RemeshOptions options = trialOptions(run.options, vertexNum);
	trial.report.seed           = run.report.seed;
	trial.report.threads        = run.report.threads;
	RunContext context{
		run.input,   options,
		run.workers, trial.report,
		trial.notes, StageClock(run.workers, trial.report, Pipeline::Remeshing, share)};
	context.guide = &guide;
	context.kept  = &kept;
	remeshInput(context, LargestDistance::Counts, trial);
	return trial;
}

/// Fewer vertices among those that meet the goal, else the smaller error.
bool isBetter(const RemeshResult& a, const RemeshResult& b, double largest)
{
	const double errorOfA = errorOf(a), errorOfB = errorOf(b);
	const bool   meetsA = errorOfA <= largest, meetsB = errorOfB <= largest;
	if (meetsA != meetsB) return meetsA;
	return meetsA ? a.mesh.vertexNum() < b.mesh.vertexNum() : errorOfA < errorOfB;
}

ErrorTrial tryCount(RunContext& run, const ErrorGoal& goal, std::int64_t vertexNum, Trials& trials)
{
	const double length = 1.0 / goal.maxTrials, from = trials.num * length;
	ErrorGuide   guide;
	guide.goal             = goal.largest;
	guide.spots            = trials.spots;
	RemeshResult     trial = remeshWith(run, vertexNum, {from, from + length}, guide, trials.kept);
	const ErrorTrial outcome{std::int64_t(trial.mesh.vertexNum()), errorOf(trial), guide.share,
							 guide.growth, guide.addedNum};
	++trials.num;
	trials.stageSeconds += secondsOf(trial.report.stages);
	if (outcome.error > goal.largest) trials.spots.push_back(std::move(guide.found));
	if (trials.num == 1 || isBetter(trial, trials.best, goal.largest))
		trials.best = std::move(trial);
	return outcome;
}

std::string lengthText(double length, double diagonal)
{
	char text[80];
	std::snprintf(text, sizeof text, "%.4g (%.3g %% of the diagonal)", length,
				  100 * length / diagonal);
	return text;
}

std::string missedText(const RemeshResult& best, const ErrorGoal& goal, double diagonal)
{
	return "An error of at most " + lengthText(goal.largest, diagonal) + " was not reached: with " +
		   std::to_string(best.mesh.vertexNum()) + " vertices it is proven to be at most " +
		   lengthText(errorOf(best), diagonal) + ".";
}

std::string metText(const RemeshResult& best, int trialNum, double diagonal)
{
	return "With " + std::to_string(best.mesh.vertexNum()) +
		   " vertices no point of either mesh is farther from the other than " +
		   lengthText(errorOf(best), diagonal) + ". This is proven. It took " +
		   std::to_string(trialNum) + (trialNum == 1 ? " trial." : " trials.");
}

} // namespace

RemeshResult remeshForError(RunContext& run)
{
	const MeshExtent extent = extentOf(run.input);
	ErrorGoal        goal   = goalOf(run.input, run.options, extent);
	KeptInput        ofTrials;
	KeptInput&       kept = run.kept != nullptr ? *run.kept : ofTrials;
	goal.start            = forecastCount(run, goal, kept);

	Trials     trials{kept, {}, {}};
	const bool met =
		searchCount(goal, [&](std::int64_t n) { return tryCount(run, goal, n, trials); }) > 0;
	RemeshResult&     best   = trials.best;
	const std::string missed = missedText(best, goal, extent.diagonal);
	if (!met && !run.options.allowNearest) throw Failure(Status::BadOptions, missed);

	const double others = trials.stageSeconds - secondsOf(best.report.stages);
	best.report.stages.push_back({"otherTrials", others});
	best.report.errorGoal     = goal.largest;
	best.report.errorTrialNum = trials.num;
	best.notes.push_back(met ? metText(best, trials.num, extent.diagonal) : missed);
	return std::move(best);
}

} // namespace gpr
