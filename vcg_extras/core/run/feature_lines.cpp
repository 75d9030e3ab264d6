// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_lines.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/crease_lines.h>
#include <vcg_extras/core/features/given_lines.h>
#include <vcg_extras/core/features/seam_edges.h>

#include <algorithm>
#include <utility>

namespace gpr {

namespace {

/// Connected feature lines shorter than this in all are dropped; in ideal edges.
constexpr float minLineLength = 3;
/// But for the rims of holes, and other clear loops, down to this.
constexpr float minLoopLength = 1.5f;
/// Of two feature lines nearer to each other than this the weaker is dropped; in ideal edges. The
/// second where lines and borders take more than this share of the vertices.
constexpr float  minLineGap = 0.15f, minCrowdedGap = 0.3f;
constexpr double maxOnCurves = 0.5;
/// Share of the vertices that lines given by the caller may take, with borders and feature lines.
constexpr double maxOnGivenLines = 0.5;

/// The seams that tell creases from noise: not where most edges were seams, as then the pieces were
/// single faces, and say nothing.
std::vector<int> tellingSeams(RunContext& run, const Prepared& p)
{
	constexpr double   mostPerFace = 0.75; // every second edge
	const CleanCounts& cleaned     = run.report.cleaned;
	const bool areMost = double(cleaned.sewnEdges) > mostPerFace * double(run.input.faceNum);
	if (cleaned.sewnEdges == 0 || cleaned.weldedVertices > 0 || areMost) return {};
	return findSeamEdges(run.input, p.surface, run.workers);
}

CreaseRules creaseRules(RunContext& run, const Prepared& p)
{
	const RemeshOptions& options = run.options;
	CreaseRules          rules;
	rules.mode            = followsFeatureLines(options) ? options.featureMode : FeatureMode::Off;
	rules.strongDeg       = float(options.featureAngleDeg);
	rules.weakDeg         = 0.5f * rules.strongDeg;
	rules.minLength       = minLineLength * idealEdge(p);
	rules.minLoop         = minLoopLength * idealEdge(p);
	rules.minSpur         = idealEdge(p);
	rules.minGap          = minLineGap * idealEdge(p);
	rules.callersMeanEdge = p.callersMeanEdge;
	if (rules.mode == FeatureMode::Auto) rules.seams = tellingSeams(run, p);
	return rules;
}

/// Of the wanted vertices, that borders and feature lines take.
double shareOf(const BoundaryCurves& curves, const Prepared& p)
{
	return double(curves.samples.size()) / double(p.targetNum);
}

/// Marks lines and cone apexes and samples them. Returns the share that their samples are of the
/// vertices wanted; 0 without lines.
double followCreases(RunContext& run, const CreaseRules& rules, Prepared& p)
{
	CreaseFindings found          = markCreases(rules, run.workers, p.surface);
	run.report.featureEdgeNum     = found.edgeNum;
	run.report.featureConeApexNum = std::int64_t(found.coneApexes.size());
	p.coneApexes                  = std::move(found.coneApexes);
	if (found.edgeNum == 0) return 0;
	p.curves       = sampleCurves(p, p.radius, borderMode(run.options, p));
	p.curvesRadius = p.radius;
	return shareOf(p.curves, p);
}

double followCreasesAgain(RunContext& run, const CreaseRules& rules, Prepared& p)
{
	forgetFeatureLines(run, p);
	return followCreases(run, rules, p);
}

void followAsManyCreasesAsFit(RunContext& run, Prepared& p)
{
	CreaseRules rules = creaseRules(run, p);
	double      share = followCreases(run, rules, p);
	if (share > maxOnCurves) {
		rules.minGap = minCrowdedGap * idealEdge(p);
		share        = followCreasesAgain(run, rules, p);
	}
	while (share > 1) {
		rules.minLength *= 2;
		rules.minLoop *= 2;
		share = followCreasesAgain(run, rules, p);
	}
}

void followGivenLines(RunContext& run, Prepared& p)
{
	const bool areAllGiven = run.options.featureMode == FeatureMode::Given;
	if (areAllGiven && run.input.line == nullptr) {
		throw Failure(Status::BadOptions,
					  "The feature lines shall be the selected edges, but no edge is selected.");
	}
	if (run.input.line == nullptr || !followsFeatureLines(run.options)) return;
	const HalfEdgeMesh& m = p.surface.mesh;
	Buffer<char>        before(m.crease.size());
	std::copy(m.crease.begin(), m.crease.end(), before.begin());
	const std::int64_t added = markGivenLines(run.input, run.workers, p.surface);
	if (added == 0) return;
	if (shareOf(sampleCurves(p, p.radius, borderMode(run.options, p)), p) <= maxOnGivenLines) {
		run.report.featureEdgeNum += added;
		p.curvesRadius = 0;
		return;
	}
	p.surface.mesh.crease.swap(before);
	run.notes.push_back("There are more given lines, like the seams of a texture, than so few "
						"vertices can follow; triangles lie across them.");
}

/// Whether anything of the result will be named by the caller's faces.
bool namesSources(const RemeshOptions& options, const Prepared& p)
{
	return options.surfacePointsOfVertices || options.surfacePointsOfFaces || !p.kept.empty();
}

} // namespace

bool followsFeatureLines(const RemeshOptions& options)
{
	return !isPaper(options);
}

bool hasFeatureLines(RunContext& run, Prepared& p)
{
	const CreaseRules    rules = creaseRules(run, p);
	const CreaseFindings found = markCreases(rules, run.workers, p.surface);
	p.surface.mesh.crease.release();
	return found.edgeNum > 0;
}

void findFeatureLines(RunContext& run, Prepared& p)
{
	run.clock.enter(Stage::FeatureLines);
	followAsManyCreasesAsFit(run, p);
	followGivenLines(run, p);
	if (!namesSources(run.options, p)) p.surface.sourceFace.release();
}

void forgetFeatureLines(RunContext& run, Prepared& p)
{
	p.surface.mesh.crease.release();
	p.coneApexes.clear();
	p.curvesRadius            = 0;
	run.report.featureEdgeNum = run.report.featureConeApexNum = 0;
}

BoundaryCurves sampleCurves(const Prepared& p, float radius, BoundaryMode border)
{
	return sampleBoundary(p.surface, radius, borderSpacing * radius, p.coneApexes, p.kept, border,
						  p.sharesBorders);
}

} // namespace gpr
