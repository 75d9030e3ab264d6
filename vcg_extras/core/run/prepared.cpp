// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/results.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// c of eq. (1) as the paper has it, from Fu and Zhou's sampler.
constexpr double printedRadiusConstant = 0.844;
/// Those that land at 98 to 99 % of the target, which the exact count makes up: placement by disk
/// intersection packs tighter than random border edges do.
constexpr double intersectionRadiusConstant = 0.962;
constexpr double borderEdgeRadiusConstant   = 0.802;

} // namespace

double vertexNumForEdgeLength(double area, double edgeLength)
{
	return 2 * area / (std::sqrt(3.0) * edgeLength * edgeLength);
}

double diskRadius(double area, double vertexNum, double constant)
{
	return 2 * std::sqrt(area) * std::sqrt(1 / (2 * std::sqrt(3.0) * vertexNum)) * constant;
}

double radiusConstant(const RemeshOptions& options)
{
	if (options.equations == Equations::AsPrinted) return printedRadiusConstant;
	return options.placement == Placement::BorderEdge ? borderEdgeRadiusConstant
													  : intersectionRadiusConstant;
}

double wantedVertexNum(const MeshView& input, const RemeshOptions& o, double area, double scale)
{
	switch (o.targetMode) {
	case TargetMode::VertexNum:
		return double(o.targetVertexNum);
	case TargetMode::Percent:
		return o.targetPercent / 100 * double(input.vertexNum);
	case TargetMode::EdgeLength:
		return vertexNumForEdgeLength(area, o.targetEdgeLen * scale);
	case TargetMode::MaxError: // a sampling alone has no error to look at
		return vertexNumForEdgeLength(area, edgePerError * o.targetMaxError * scale);
	}
	return 0;
}

std::int64_t resolveTarget(const MeshView& input, const RemeshOptions& o, double area, double scale)
{
	const double n = std::round(wantedVertexNum(input, o, area, scale));
	if (n > mostResultVertices) {
		throw Failure(Status::OutOfMemory, "The result would have more than 200,000,000 vertices.");
	}
	return std::max<std::int64_t>(1, std::int64_t(n));
}

float idealEdge(const Prepared& p)
{
	return float(p.radiusFactor * diskRadius(p.area, double(p.targetNum), 1));
}

void setTarget(RunContext& run, std::int64_t targetNum, Prepared& p)
{
	p.targetNum = targetNum;
	p.radius =
		float(p.radiusFactor * diskRadius(p.area, double(targetNum), radiusConstant(run.options)));
	run.report.targetVertexNum = targetNum;
	run.report.diskRadius      = double(p.radius) / p.surface.frame.scale;
}

} // namespace gpr
