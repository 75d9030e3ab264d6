// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reporting.h"

#include <vcg_extras/core/sampling/target.h>

#include <chrono>
#include <utility>

namespace gpr {

namespace {

/// The radius of the samples, or the radius for a later count, mesh units.
double reportedRadius(const RunContext& run, const Products& made, const Decisions& decisions)
{
	const bool  isOfSamples = made.samples.spacedFor == decisions.vertexNum;
	const float radius =
		isOfSamples ? made.samples.radius : usualRadius(made, run.options, decisions.vertexNum);
	return double(radius) / made.surface.frame.scale;
}

void reportInput(const MeshView& input, const WorkingSurface& surface, RemeshReport& report)
{
	report.cleaned      = surface.cleaned;
	report.cleanedInput = surface.figures;
	report.border       = surface.border;
	report.input        = surface.figures;
	if (surface.figures.faces == 0) return;
	report.input.vertices = std::int64_t(input.vertexNum);
	report.input.faces    = std::int64_t(input.faceNum);
}

void reportSamples(const RunContext& run, const Products& made, const Decisions& decisions,
				   RemeshReport& report)
{
	if (!(made.surface.area > 0) || decisions.vertexNum == 0) return;
	report.radiusConstant      = radiusConstant(run.options);
	report.targetVertexNum     = decisions.wholeNum();
	report.diskRadius          = reportedRadius(run, made, decisions);
	report.curvatureClampedNum = made.sizes.clampedNum;
	report.regionVertexNum     = made.sizes.regionVertexNum;
	report.featureEdgeNum      = made.lines.edgeNum;
	report.featureConeApexNum  = std::int64_t(made.lines.found.coneApexes.size());
	report.sampleNum           = made.samples.num;
	report.boundarySampleNum   = made.samples.onCurveNum;
	report.samplesMoved        = made.samples.movedNum;
	report.largestSampleMove   = double(made.samples.farthest) / made.surface.frame.scale;
}

void reportResult(const Products& made, RemeshReport& report)
{
	const ResultMesh&   result     = made.result;
	const Verification& verified   = made.verified;
	report.leftoverVertexNum       = result.leftoverNum;
	report.splitNum                = result.splitNum;
	report.collapseNum             = result.collapseNum;
	report.flipNum                 = result.flipNum;
	report.releasedVertexNum       = made.releasedNum;
	report.largestFitDistance      = double(verified.fitDistance) / made.surface.frame.scale;
	report.result                  = verified.figures;
	report.audit                   = verified.audit;
	report.audit.guarded           = made.guarded;
	report.check                   = verified.check;
	report.isDistanceProven        = verified.proof.isMade;
	report.provenDistance          = verified.proof.bounds;
	report.radiusConstantForTarget = verified.constantForTarget;
	report.keptVertexNum           = verified.keptNum;
	report.quality                 = made.quality;
	report.regularVertexNum        = made.regularNum;
}

} // namespace

Told tellOf(RunContext& run, const Products& made, const Decisions& decisions)
{
	Told          told;
	RemeshReport& report = told.report;
	report.seed          = run.options.seed;
	report.threads       = run.workers.threadNum();
	report.adapt         = made.sizes.adapt.value_or(*run.options.adapt);
	report.stages        = run.clock.finish();
	report.capsReached   = run.capsReached;
	reportInput(run.input, made.surface, report);
	reportSamples(run, made, decisions, report);
	reportResult(made, report);
	told.notes = run.notes;
	return told;
}

void Told::addHalf(RemeshReport half)
{
	half.capsReached.insert(half.capsReached.end(), report.capsReached.begin(),
							report.capsReached.end());
	half.stages                     = std::move(report.stages);
	half.input                      = report.input;
	half.cleanedInput               = report.cleanedInput;
	half.cleaned                    = report.cleaned;
	half.result                     = report.result;
	half.quality                    = report.quality;
	half.check                      = report.check;
	half.targetVertexNum            = report.result.vertices;
	half.largestFitDistance         = report.largestFitDistance;
	half.isDistanceProven           = report.isDistanceProven;
	half.provenDistance             = report.provenDistance;
	const GuardedFigures made       = half.audit.guarded;
	half.audit                      = report.audit;
	half.audit.guarded.isTested     = made.isTested;
	half.audit.guarded.foundPairNum = made.foundPairNum + report.audit.guarded.pairNum;
	half.audit.guarded.vertexNum    = 2 * made.vertexNum;
	report                          = std::move(half);
}

void addTimes(const RemeshResult& half, StageClock& clock)
{
	clock.add(half.report.stages);
}

void Told::addOtherRuns(StageClock::Clock::time_point start)
{
	const std::chrono::duration<double> whole = StageClock::Clock::now() - start;
	double                              other = whole.count();
	for (const StageTime& s : report.stages)
		other -= s.seconds;
	report.stages.push_back({"otherTrials", other});
}

void Told::addTrials(double goal, int trialNum, const std::string& outcome)
{
	report.errorGoal     = goal;
	report.errorTrialNum = trialNum;
	notes.push_back(outcome);
}

} // namespace gpr
