// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_SURFACE_STAGES_H
#define VCG_EXTRAS_CORE_RUN_SURFACE_STAGES_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/sampling/fine_spots.h>

namespace gpr {

// What is found out about the working surface before it is sampled.

/// The paper's removal of vertices knows no curves but the border.
bool followsFeatureLines(const RemeshOptions& options);

/// Step Sizes: finds the feature region and how large triangles are to be where, and splits edges
/// that are too long for small triangles. The sizes go with the vertices. spots: where an error
/// asks for smaller triangles. Throws Failure where the selection is to be preserved and empty.
SizeFacts makeSizes(RunContext& run, const Decisions& decisions, const FineSpots& spots,
					Products& made);

/// Step Forecast: the count with which triangles would be as flat as an error asks for, but for few
/// of them.
ForecastFacts forecastCount(RunContext& run, const Decisions& decisions, const ErrorGoal& goal,
							Products& made);

/// Step Lines: marks the feature lines that the surface has by itself. From here on the surface
/// does not change any more. With each higher line limit fewer are marked: first the weaker one of
/// two close lines is left out, then the shorter ones.
LineFacts findLines(RunContext& run, const Decisions& decisions, Products& made);

/// Step GivenLines: adds the caller's own lines where they leave enough vertices to the surface
/// between them. Throws Failure where all lines are to be the caller's and there are none.
NoFacts followGivenLines(RunContext& run, const Decisions& decisions, Products& made);

/// Samples of border and feature lines for disks of a radius, working units.
BoundaryCurves sampleCurves(const RunContext& run, const Decisions& decisions, float radius,
							const Products& made);

} // namespace gpr

#endif
