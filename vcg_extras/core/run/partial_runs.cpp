// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "partial_runs.h"

#include "detection.h"
#include "feature_lines.h"
#include "given_samples.h"
#include "improvement.h"
#include "kept_input.h"
#include "loading.h"
#include "preparation.h"
#include "sample_stages.h"
#include "target.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/feature_export.h>
#include <vcg_extras/core/output/export.h>
#include <vcg_extras/core/output/verification.h>
#include <vcg_extras/core/surface/barycentric_point.h>

#include <utility>

namespace gpr {

namespace {

void exportSamples(RunContext& run, const Surface& surface, const Sampling& sampling,
				   SamplingResult& out)
{
	run.clock.enter(Stage::Export);
	for (const Sample& s : sampling.samples) {
		out.points.push_back(surface.frame.toCaller(s.point.position));
		out.surfacePoints.push_back(barycentricPoint(run.input, surface, s.point));
		out.radii.push_back(run.report.diskRadius * double(s.size));
	}
	out.diskRadius = run.report.diskRadius;
}

} // namespace

void sampleInput(RunContext& run, SamplingResult& out)
{
	Prepared p = prepare(run, regionOfRun(run));
	requireRoomForKept(run.options, p.targetNum, std::int64_t(p.kept.size()));
	findFeatureLines(run, p);
	const Sampled sampled = sampleSurface(run, p);
	exportSamples(run, p.surface, sampled.sampling, out);
}

void meshGivenSamples(RunContext& run, const std::vector<Vec3d>& points, RemeshResult& out)
{
	if (points.empty()) throw Failure(Status::BadOptions, "There are no samples.");
	const Prepared p     = prepareFor(run, {}, std::int64_t(points.size()));
	GivenSamples   given = takeOverSamples(run, p, points);
	Sampled        sampled;
	sampled.partition = cutForSampling(run, p);
	sampled.sampling  = std::move(given.sampling);
	Meshed made       = retriangulateSamples(run, p, std::move(sampled));
	run.clock.enter(Stage::Flips);
	flipEdges(run, made.result);
	run.report.targetVertexNum = made.result.mesh.vertexNum;
	verifyResult(run, p.surface, made.result, {0, std::int64_t(p.kept.size())});
	exportResult(run, p.surface, made.result, out);
	nameSamples(points, given.isMoved, made.result, out);
}

void detectOnly(RunContext& run, FeatureResult& out)
{
	const DetectedFeatures found = detectOnInput(run);
	describeInput(run, found.surface);
	run.clock.enter(Stage::Export);
	exportFeatures(run.input, found.surface, found.features, out);
}

} // namespace gpr
