// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reporting.h"

#include <vcg_extras/core/sampling/target.h>

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
	report.samplesMoved        = made.samples.given.movedNum;
	report.largestSampleMove   = double(made.samples.given.farthest) / made.surface.frame.scale;
}

void reportEdits(const Products& made, RemeshReport& report)
{
	report.leftoverVertexNum       = made.result.leftoverNum;
	report.splitNum                = made.result.splitNum;
	report.collapseNum             = made.result.collapseNum;
	report.flipNum                 = made.result.flipNum;
	report.releasedVertexNum       = made.releasedNum;
	report.radiusConstantForTarget = made.verified.constantForTarget;
	report.keptVertexNum           = made.verified.keptNum;
	report.regularVertexNum        = made.regularNum;
}

void reportResult(const Products& made, RemeshReport& report)
{
	const Verification& verified = made.verified;
	report.largestFitDistance    = double(verified.fitDistance) / made.surface.frame.scale;
	report.result                = verified.figures;
	report.audit                 = verified.audit;
	report.audit.guarded         = made.guarded;
	report.check                 = verified.check;
	report.isDistanceProven      = verified.proof.isMade;
	report.provenDistance        = verified.proof.bounds;
	report.quality               = made.quality;
}

} // namespace

Outcome tellOf(RunContext& run, const Products& made, const Decisions& decisions)
{
	Outcome       told;
	RemeshReport& report = told.report;
	report.seed          = run.options.seed;
	report.threads       = run.workers.threadNum();
	report.adapt         = made.sizes.adapt.value_or(*run.options.adapt);
	report.stages        = run.clock.finish();
	report.capsReached   = run.capsReached;
	reportInput(run.input, made.surface, report);
	reportSamples(run, made, decisions, report);
	reportEdits(made, report);
	reportResult(made, report);
	told.notes = run.notes;
	return told;
}

Outcome tellOfWhole(RunContext& run, const Products& made, RemeshReport half)
{
	Outcome              told   = tellOf(run, made, Decisions());
	RemeshReport&        whole  = told.report;
	const GuardedFigures ofHalf = half.audit.guarded;
	half.stages                 = std::move(whole.stages);
	half.capsReached.insert(half.capsReached.end(), whole.capsReached.begin(),
							whole.capsReached.end());
	reportInput(run.input, made.surface, half);
	reportResult(made, half);
	half.audit.guarded.isTested = ofHalf.isTested;
	half.audit.guarded.foundPairNum += ofHalf.foundPairNum;
	half.audit.guarded.vertexNum = ofHalf.vertexNum;
	whole                        = std::move(half);
	return told;
}

void addTimes(const RemeshResult& half, StageClock& clock)
{
	clock.add(half.report.stages);
}

void addOtherRuns(StageClock::Clock::time_point start, Outcome& told)
{
	double other = StageClock::secondsSince(start);
	for (const StageTime& s : told.report.stages)
		other -= s.seconds;
	told.report.stages.push_back({"otherTrials", other});
}

} // namespace gpr
