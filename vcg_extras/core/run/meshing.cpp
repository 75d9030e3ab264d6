// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing.h"

#include "feature_lines.h"
#include "improvement.h"
#include "preparation.h"
#include "target.h"
#include "verdict.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/optimization/exact_count.h>
#include <vcg_extras/core/output/audit.h>

#include <utility>

namespace gpr {

namespace {

Request requestOf(const RemeshOptions& options, const Prepared& p)
{
	return {!isPaper(options), isTargetWish(options), std::int64_t(p.kept.size())};
}

/// Everything before the count is the same for every count that topology alone is to reach, so that
/// the smallest one is.
std::int64_t countToPrepareFor(const Attempt& attempt)
{
	return attempt.way == Way::ByTopology ? 1 : attempt.vertexNum;
}

/// The surface for an attempt after the first one; the last one's is taken where it fits.
Prepared prepareAgain(RunContext& run, const FeatureMarks& marks, const Attempt& attempt,
					  Prepared last)
{
	const std::int64_t vertexNum     = countToPrepareFor(attempt);
	Prepared           p             = std::move(last);
	const bool         seamsAreRight = !(attempt.leavesSeamsOpen && p.isSewn);
	if (p.madeFor != vertexNum || !seamsAreRight) {
		p = Prepared(); // its memory is needed
		p = prepareFor(run, marks, vertexNum,
					   attempt.leavesSeamsOpen ? Sewing::Never : Sewing::NotYet);
	}
	setTarget(run, vertexNum, p);
	forgetFeatureLines(run, p);
	p.keepsRaggedBorder = attempt.keepsRaggedBorder;
	return p;
}

void countBySamples(RunContext& run, const Prepared& p, Meshed& made)
{
	if (isPaper(run.options)) return;
	run.clock.enter(Stage::Count);
	collapseShortEdges(p.surface, made.result, run.workers);
	reachExactCount(p.surface, made.curves, p.targetNum, made.result, run.workers);
}

void countByTopology(RunContext& run, std::int64_t vertexNum, Prepared& p, Meshed& made)
{
	setTarget(run, vertexNum, p);
	made.result.idealEdge = idealEdge(p);
	run.clock.enter(Stage::Count);
	reachCountByTopology(p.surface, made.curves, vertexNum, made.result, run.workers);
}

MeshedSurface makeMesh(RunContext& run, const Attempt& attempt, Prepared prepared)
{
	MeshedSurface made;
	made.prepared = std::move(prepared);
	made.meshed   = sampleAndRetriangulate(run, made.prepared);
	if (attempt.way == Way::ByTopology)
		countByTopology(run, attempt.vertexNum, made.prepared, made.meshed);
	else
		countBySamples(run, made.prepared, made.meshed);
	improve(run, made.prepared, made.meshed.curves, made.meshed.result);
	return made;
}

Outcome outcomeOf(RunContext& run, const Prepared& p, const ResultMesh& result)
{
	return {result.mesh.vertexNum, run.report.featureEdgeNum > 0,
			lineFaceNum(result.mesh, run.workers) > 0, result.hasSmoothBorder, p.isSewn};
}

void tell(RunContext& run, const Verdict& verdict)
{
	if (verdict.kind == Verdict::Kind::Refuse)
		throw Failure(Status::CountTooSmall, verdict.sentence, verdict.smallestVertexNum);
	if (!verdict.sentence.empty()) run.notes.push_back(verdict.sentence);
}

void aimAtReached(RunContext& run, const Meshed& meshed, Prepared& p)
{
	const std::int64_t reached = meshed.result.mesh.vertexNum;
	if (!isPaper(run.options) && reached != p.targetNum) setTarget(run, reached, p);
}

} // namespace

MeshedSurface meshForTarget(RunContext& run, const FeatureMarks& marks, Prepared prepared)
{
	const Request request = requestOf(run.options, prepared);
	Attempt       attempt = firstAttempt(prepared.targetNum);
	MeshedSurface made    = makeMesh(run, attempt, std::move(prepared));
	while (true) {
		const Verdict verdict =
			judge(request, attempt, outcomeOf(run, made.prepared, made.meshed.result));
		tell(run, verdict);
		if (verdict.kind == Verdict::Kind::Accept) break;
		attempt     = verdict.next;
		made.meshed = Meshed(); // its memory is needed
		prepared    = prepareAgain(run, marks, attempt, std::move(made.prepared));
		made        = makeMesh(run, attempt, std::move(prepared));
	}
	aimAtReached(run, made.meshed, made.prepared);
	return made;
}

} // namespace gpr
