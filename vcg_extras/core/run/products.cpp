// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "products.h"

#include <vcg_extras/core/sampling/target.h>

namespace gpr {

void Samples::release()
{
	partition = OctreeBlocks();
	curves    = BoundaryCurves();
	sampling  = Sampling();
	fused     = FusedMesh();
}

void Products::dropFrom(Step step)
{
	if (step > Step::Relaxation) return; // the steps from Fit on change the mesh at hand
	result = ResultMesh();
	curves = BoundaryCurves();
	if (step > Step::Lines) return;
	samples = Samples();
	if (step > Step::Input) return;
	lines   = Lines();
	sizes   = Sizes();
	surface = WorkingSurface();
	input.reset();
}

float usualRadius(const Products& made, const RemeshOptions& options, std::int64_t vertexNum)
{
	const double even = diskRadius(made.surface.area, double(vertexNum), radiusConstant(options));
	return float(made.sizes.radiusFactor * even);
}

float idealEdge(const Products& made, std::int64_t vertexNum)
{
	return float(made.sizes.radiusFactor * diskRadius(made.surface.area, double(vertexNum), 1));
}

BoundaryMode borderMode(const RemeshOptions& options, const Decisions& decisions)
{
	return decisions.keepsRaggedBorder ? BoundaryMode::Resample : options.boundary;
}

} // namespace gpr
