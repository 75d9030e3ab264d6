// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_run.h"

#include "border_smoothing.h"
#include "detection.h"
#include "error_guide.h"
#include "feature_lines.h"
#include "meshing.h"
#include "preparation.h"
#include "target.h"

#include <vcg_extras/core/output/distance_proof.h>
#include <vcg_extras/core/output/export.h>
#include <vcg_extras/core/output/verification.h>

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
	if (run.options.featureMode == FeatureMode::Off || followsFeatureLines(run.options)) return;
	run.notes.push_back("Feature lines are not followed where vertices are removed one by one.");
}

void measureError(RunContext& run, const Surface& surface, const ResultMesh& result)
{
	run.clock.enter(Stage::Error);
	const ComparedSurfaces both(surface, result, run.workers);
	proveDistance(run, surface, both);
	if (run.guide != nullptr) findPlacesBeyond(run, surface, both, result.idealEdge);
}

} // namespace

void remeshInput(RunContext& run, LargestDistance largest, RemeshResult& out)
{
	const FeatureMarks marks    = detectRegion(run);
	Prepared           prepared = prepareWithRoom(run, marks);
	findFeatureLines(run, prepared);
	tellLinesNotFollowed(run);

	MeshedSurface  made    = meshForTarget(run, marks, std::move(prepared));
	const Surface& surface = made.prepared.surface;
	ResultMesh&    result  = made.meshed.result;
	const Expected expected{made.prepared.targetNum, std::int64_t(made.prepared.kept.size())};

	fitResult(run, made.prepared, made.meshed.curves, largest, result);
	if (largest == LargestDistance::Counts) measureError(run, surface, result);
	tellSmoothBorder(run, surface, result);
	verifyResult(run, surface, result, expected);
	exportResult(run, surface, result, out);
}

} // namespace gpr
