// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_figures.h"

namespace gpr_filter {

Figures remeshingFigures(const gpr::RemeshResult& result)
{
	const gpr::RemeshReport&   r = result.report;
	const gpr::QualityFigures& q = r.quality;
	return {
		{"vertex_number", double(r.result.vertices)},
		{"face_number", double(r.result.faces)},
		{"disk_radius", r.diskRadius},
		{"mean_edge_length", q.meanEdgeLen},
		{"mean_radius_ratio", q.radiusRatioMean},
		{"mean_aspect_ratio", q.aspectRatioMean},
		{"min_angle", q.minAngleDeg},
		{"max_angle", q.maxAngleDeg},
		{"below_30_percent", q.below30Percent},
		{"seconds", r.remeshSeconds},
	};
}

Figures samplingFigures(const gpr::SamplingResult& result)
{
	return {
		{"point_number", double(result.points.size())},
		{"disk_radius", result.diskRadius},
		{"seconds", result.report.remeshSeconds},
	};
}

Figures featureFigures(const gpr::FeatureResult& result)
{
	const gpr::FeatureFigures& f = result.figures;
	return {
		{"edge_number", double(f.edgeNum)},       {"line_number", double(f.lineNum)},
		{"corner_number", double(f.cornerNum)},   {"tip_number", double(f.coneApexNum)},
		{"vertex_number", double(f.vertexNum)},   {"face_number", double(f.faceNum)},
		{"seconds", result.report.remeshSeconds},
	};
}

} // namespace gpr_filter
