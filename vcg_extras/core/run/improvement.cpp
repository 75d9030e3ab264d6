// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "improvement.h"

#include <vcg_extras/core/base/pages.h>
#include <vcg_extras/core/optimization/angle_mending.h>
#include <vcg_extras/core/optimization/crease_sides.h>
#include <vcg_extras/core/optimization/crossing_mending.h>
#include <vcg_extras/core/optimization/delaunay_flips.h>
#include <vcg_extras/core/optimization/fit.h>
#include <vcg_extras/core/optimization/fold_repair.h>
#include <vcg_extras/core/optimization/patch_remeshing.h>
#include <vcg_extras/core/optimization/relaxation.h>
#include <vcg_extras/core/optimization/valence_glide.h>
#include <vcg_extras/core/optimization/worst_triangles.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Angles below these get a pass of their own at the end.
constexpr float poorAngleDeg = 32, poorAngleFullDeg = 38;
/// What is left of the weight of the triangles' shape in the fit where sizes follow the error: who
/// asks for that wants to be close first.
constexpr double adaptedShapeWeight = 0.07;
/// Angles that the fit and the last pass hold there: sharp tips and folds come out closer.
constexpr float adaptedAngleDeg = 26;
/// Rounds of the fit, and of the quick one; a fourth takes 1 to 3 % off the error where sizes are
/// the same everywhere, and as much again where they follow it.
constexpr int fitRounds        = 3;
constexpr int adaptedFitRounds = 4;
constexpr int quickFitRounds   = 2;
/// Rounds of lowering the largest distances there; one of them takes a fifth off.
constexpr int adaptedWorstRounds = 4;

class Improvement : RunPart {
public:
	explicit Improvement(RunContext& run) : RunPart(run) {}

	void relax(const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
	{
		clock_.enter("relaxation", "Relaxing", 0.95);
		if (options_.smoothing != Smoothing::Barycentric)
			return smoothAsWritten(p, boundary, result);
		const bool isFull = options_.regularity == Regularity::Full;
		if (options_.relaxIterations > 0) {
			if (isFull)
				makeRegular(p, boundary, result);
			else
				relaxPlainly(p, boundary, result);
			raiseWorstAngles(p.surface, isFull ? poorAngleFullDeg : poorAngleDeg, result, workers_);
		}
		mendFolds(p.surface, boundary, false, result, workers_);
		alignFacesAtCreases(p.surface, boundary, result, workers_);
	}

	/// What regularity asks for to the last; the paper's post-processing stays as it is written.
	void mendLastAngles(const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result,
						std::unique_ptr<Cells> cells)
	{
		if (options_.smoothing != Smoothing::Barycentric || options_.relaxIterations == 0) return;
		if (options_.regularity != Regularity::Full) return;
		clock_.enter("angles", "Mending angles", 0.973);
		returnReleasedMemory();
		if (!mendAngles(p.surface, boundary, leastAngleDeg(), result, workers_, cells,
						left_.largestGap))
			report_.capsReached.push_back("changes for the worst angles");
		const std::int64_t targetNum = options_.exactCount ? p.targetNum : 0;
		remeshPoorPatches(p.surface, boundary, leastAngleDeg(), targetNum, result, workers_, cells,
						  left_);
	}

	/// Returns the cells of the last round, if there was one.
	std::unique_ptr<Cells> fit(const Prepared& p, const BoundaryCurves& boundary,
							   bool largestCounts, ResultMesh& result)
	{
		if (options_.fit == Fit::Off) return nullptr;
		clock_.enter("fit", "Fitting to the input", 0.97);
		returnReleasedMemory(); // this stage sets the peak
		FitSettings settings;
		settings.rounds        = roundsOfFit();
		settings.leastAngleDeg = leastAngleDeg();
		settings.worstRounds   = worstRounds(largestCounts);
		settings.shapeWeight *= float(std::pow(adaptedShapeWeight, options_.adapt));
		FitOutcome outcome = fitToInput(p.surface, boundary, settings, result, workers_);
		if (outcome.capped) report_.capsReached.push_back("moves of the fit");
		if (outcome.cells != nullptr) {
			left_.crossing = mendCrossings(p.surface, boundary, leastAngleDeg(), outcome.crossing,
										   *outcome.cells, result, workers_);
			if (!outcome.crossing.empty()) outcome.farthest = farthestFromAnchor(result);
		}
		report_.largestFitDistance = double(outcome.farthest) / p.surface.frame.scale;
		left_.largestGap           = outcome.largestGap;
		return std::move(outcome.cells);
	}

private:
	LeftOver left_; ///< by the fit

	float leastAngleDeg() const
	{
		return poorAngleDeg + float(options_.adapt) * (adaptedAngleDeg - poorAngleDeg);
	}

	int worstRounds(bool largestCounts) const
	{
		if (largestCounts || options_.adapt > 0) return adaptedWorstRounds;
		return options_.fit == Fit::Quick ? 0 : 1;
	}

	int roundsOfFit() const
	{
		if (options_.fit == Fit::Quick) return quickFitRounds;
		return options_.adapt > 0 ? adaptedFitRounds : fitRounds;
	}

	/// The paper's post-processing: umbrella and flips in turn, or flips alone.
	void smoothAsWritten(const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
	{
		const bool moves = options_.smoothing == Smoothing::Umbrella2;
		for (int step = 0; moves && step < options_.relaxIterations; ++step) {
			smoothByUmbrella2(p.surface, result, workers_);
			flipEdges(run_, result);
		}
		mendFolds(p.surface, boundary, false, result, workers_);
	}

	/// The first two steps leave the edges alone: flips straight away would undo what the exact
	/// count did for the valences.
	void relaxPlainly(const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
	{
		constexpr int stepsWithoutFlips = 2;
		for (int step = 0; step < options_.relaxIterations; ++step) {
			relaxOnce(p.surface, result, workers_);
			slideAlongCreases(p.surface, boundary, result);
			if (step >= stepsWithoutFlips) flipEdges(run_, result);
		}
	}

	/// Chains of flips shear triangles; a relaxation before each round gives them room.
	void makeRegular(const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
	{
		constexpr int rounds = 2;
		for (int round = 0; round < rounds; ++round) {
			relaxOnce(p.surface, result, workers_);
			slideAlongCreases(p.surface, boundary, result);
			glideDislocations(result, workers_);
		}
		ConformalSteps steps = conformalSteps(2 * options_.relaxIterations);
		steps.flipPasses     = options_.flipIterations;
		relaxConformally(p.surface, boundary, steps, result, workers_);
	}
};

} // namespace

void flipEdges(RunContext& run, ResultMesh& result)
{
	flipToDelaunay(result, run.workers, run.options.flipIterations);
}

void improve(RunContext& run, const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
{
	Improvement(run).relax(p, boundary, result);
}

void fitResult(RunContext& run, const Prepared& p, const BoundaryCurves& boundary,
			   bool largestCounts, ResultMesh& result)
{
	Improvement            improvement(run);
	std::unique_ptr<Cells> cells = improvement.fit(p, boundary, largestCounts, result);
	improvement.mendLastAngles(p, boundary, result, std::move(cells));
}

} // namespace gpr
