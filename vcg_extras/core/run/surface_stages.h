// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_SURFACE_STAGES_H
#define VCG_EXTRAS_CORE_RUN_SURFACE_STAGES_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>

namespace gpr {

// The steps that examine the working surface before the sampling.

/// Step Sizes: finds the feature region and the local sizes, and splits edges that are too long for
/// small triangles. The sizes are attached to the vertices. Throws Failure if the selection is
/// the feature region and is empty.
SizeFacts makeSizes(RunContext& run, const Decisions& decisions, Products& made);

/// Step Forecast: forecasts the count with triangles as flat as the error bound needs, except for a
/// few triangles.
ForecastFacts forecastCount(RunContext& run, const Decisions& decisions, const ErrorGoal& goal,
							Products& made);

/// Step Lines: marks the feature lines found on the surface. The surface does not change after this
/// step. A higher line limit leaves fewer lines: first without the weaker of two close lines, then
/// also without the shorter lines.
LineFacts findLines(RunContext& run, const Decisions& decisions, Products& made);

/// Step GivenLines: adds the lines of the user, if the lines leave enough vertices for the surface
/// between them. Throws Failure if the options allow given lines only and there are none.
void followGivenLines(RunContext& run, const Decisions& decisions, Products& made);

/// The number of vertices of the whole mesh for the first `num` samples.
template <class Samples>
std::int64_t wholeNum(const HalfEdgeMesh& mesh, const Samples& samples, std::size_t num)
{
	std::int64_t whole = 0;
	for (std::size_t i = 0; i < num; ++i)
		whole += mesh.multiplicity(samples[i].point.position);
	return whole;
}

/// Samples borders and feature lines for disks of a radius, working units.
BoundaryCurves sampleCurves(RunContext& run, const Decisions& decisions, float radius,
							const Products& made);

} // namespace gpr

#endif
