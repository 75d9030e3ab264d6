// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_goal_run.h"

#include "error_goal.h"
#include "remesh_run.h"
#include "target.h"

#include <vcg_extras/core/base/failure.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

namespace gpr {

namespace {

/// What the trials so far came to.
struct Trials {
	RemeshResult best;
	int          num          = 0;
	double       stageSeconds = 0; ///< of all of them
};

ErrorGoal goalOf(const MeshView& input, const RemeshOptions& options, const MeshExtent& extent)
{
	ErrorGoal goal;
	goal.largest = options.targetMaxError * (options.maxErrorIsPercent ? extent.diagonal / 100 : 1);
	goal.most    = std::min<std::int64_t>(200000000, 1000 + 2 * std::int64_t(input.vertexNum));
	const double edge = edgePerError * goal.largest;
	const double n    = edge > 0 ? vertexNumForEdgeLength(extent.area, edge) : 1;
	goal.start        = std::int64_t(std::min(double(goal.most), std::max(1.0, n)));
	return goal;
}

RemeshOptions trialOptions(RemeshOptions options, std::int64_t vertexNum)
{
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = vertexNum;
	options.allowNearest    = true;
	return options;
}

double secondsOf(const std::vector<StageTime>& stages)
{
	double sum = 0;
	for (const StageTime& s : stages)
		sum += s.seconds;
	return sum;
}

/// A whole run of its own, with this share of the work.
RemeshResult remeshWith(RunContext& run, std::int64_t vertexNum, WorkShare share)
{
	RemeshResult        trial;
	const RemeshOptions options = trialOptions(run.options, vertexNum);
	trial.report.seed           = run.report.seed;
	trial.report.threads        = run.report.threads;
	RunContext context{
		run.input,   options,
		run.workers, trial.report,
		trial.notes, StageClock(run.workers, trial.report, Pipeline::Remeshing, share)};
	remeshInput(context, LargestDistance::Counts, trial);
	return trial;
}

/// Fewer vertices among those that meet the goal, else the smaller error.
bool isBetter(const RemeshResult& a, const RemeshResult& b, double largest)
{
	const double errorOfA = a.report.largestError, errorOfB = b.report.largestError;
	const bool   meetsA = errorOfA <= largest, meetsB = errorOfB <= largest;
	if (meetsA != meetsB) return meetsA;
	return meetsA ? a.mesh.vertexNum() < b.mesh.vertexNum() : errorOfA < errorOfB;
}

ErrorTrial tryCount(RunContext& run, const ErrorGoal& goal, std::int64_t vertexNum, Trials& trials)
{
	const double     length = 1.0 / goal.maxTrials, from = trials.num * length;
	RemeshResult     trial = remeshWith(run, vertexNum, {from, from + length});
	const ErrorTrial outcome{std::int64_t(trial.mesh.vertexNum()), trial.report.largestError};
	++trials.num;
	trials.stageSeconds += secondsOf(trial.report.stages);
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
		   std::to_string(best.mesh.vertexNum()) + " vertices it is " +
		   lengthText(best.report.largestError, diagonal) + ".";
}

std::string metText(const RemeshResult& best, int trialNum, double diagonal)
{
	return "The largest distance from the input that was found with " +
		   std::to_string(best.mesh.vertexNum()) + " vertices is " +
		   lengthText(best.report.largestError, diagonal) + ", in " + std::to_string(trialNum) +
		   " trials. It was found by sampling, which is no proof.";
}

} // namespace

RemeshResult remeshForError(RunContext& run)
{
	const MeshExtent extent = extentOf(run.input);
	const ErrorGoal  goal   = goalOf(run.input, run.options, extent);
	Trials           trials;
	const bool       met =
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
