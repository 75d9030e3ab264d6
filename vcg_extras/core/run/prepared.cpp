// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared.h"

#include <cmath>

namespace gpr {

namespace {

/// c of eq. (1) as the paper has it, from Fu and Zhou's sampler.
constexpr double printedRadiusConstant = 0.844;
/// The one that lands at 98 to 99 % of the target, which the exact count makes up: placement by
/// disk intersection packs tighter than random border edges do.
constexpr double intersectionRadiusConstant = 0.962;

} // namespace

BoundaryMode borderMode(const RemeshOptions& options, const Prepared& p)
{
	return p.keepsRaggedBorder ? BoundaryMode::Resample : options.boundary;
}

double diskRadius(double area, double vertexNum, double constant)
{
	return 2 * std::sqrt(area) * std::sqrt(1 / (2 * std::sqrt(3.0) * vertexNum)) * constant;
}

double radiusConstant(const RemeshOptions& options)
{
	return isPaper(options) ? printedRadiusConstant : intersectionRadiusConstant;
}

float idealEdge(const Prepared& p)
{
	return float(p.radiusFactor * diskRadius(p.area, double(p.targetNum), 1));
}

float evenEdge(const Prepared& p)
{
	return float(diskRadius(p.area, double(p.targetNum), 1));
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
