// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "detection.h"

#include "loading.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/feature_export.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/results.h>

namespace gpr {

namespace {

/// Of the time of a run with a tenth of the vertices, about.
constexpr double detectionShare = 0.5;

void tellLimits(RunContext& run, const FeatureEdges& features)
{
	if (features.supportCut) {
		run.notes.push_back("The feature support was cut to 5 % of the square root of the area; "
							"the mesh is too coarse for more.");
	}
	if (features.cappedRayNum > 0) {
		run.tellCap("faces crossed by the rays of the feature support");
	}
}

} // namespace

DetectedFeatures detectOnInput(RunContext& run)
{
	DetectedFeatures found;
	IndexedMesh      mesh = loadCleaned(run);
	found.surface.frame   = mesh.frame;
	const float meanEdge  = meanEdgeLength(mesh, run.workers);
	if (!(meanEdge > 0)) throw Failure(Status::UnusableInput, "The surface has no area.");
	connectOrRepair(run, mesh, found.surface);
	dropFlatPieces(run, found.surface);
	run.clock.enter(Stage::Detection);
	found.features =
		findFeatures(found.surface, run.options.featureThresholds, meanEdge, run.workers);
	tellLimits(run, found.features);
	return found;
}

FeatureMarks detectRegion(RunContext& run)
{
	if (run.options.featureRegion != FeatureRegion::Detected) return {};
	run.clock.beginFirstPart(Pipeline::Detection, detectionShare);
	const DetectedFeatures found = detectOnInput(run);
	FeatureResult          result;
	exportFeatures(run.input, found.surface, found.features, result);
	run.clock.endFirstPart();
	run.report.cleaned = CleanCounts();
	if (result.figures.vertexNum > 0) return result.vertexFeature;
	run.notes.push_back("No features were detected, so that there is no feature region.");
	return {};
}

} // namespace gpr
